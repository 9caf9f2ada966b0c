// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_channel
// Messages survive the wire; what is no message, or says what cannot be, is refused by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bridge/channel/hello.hpp"
#include "bridge/wire/codec.hpp"
#include "bridge/wire/messages_generated.h"

namespace blockweir::wire {
namespace {

Load sample() {
  return {.window = 17,
          .time_s = 0.17,
          .holds_until_s = std::numeric_limits<double>::infinity(),
          .upstream_level_m = 22,
          .downstream_level_m = std::nan(""),
          .block = {1, 2},
          .edge = {3, 0},
          .s_from = {0, 0.25},
          .s_to = {0.5, 1},
          .pressure_from_pa = {1e4, 2e4},
          .pressure_to_pa = {3e4, 0},
          .cracks_from = 1,
          .breached = true,
          .added_mass = {{}, {4e4, -1, 2e5, 3e3, 0.5, 1e6}}};
}

std::string refusal(const Load& load) {
  flatbuffers::FlatBufferBuilder builder;
  encode(load, builder);
  Load into;
  try {
    EXPECT_EQ(verify(builder.GetBufferPointer(), builder.GetSize()), Kind::load);
    decode(builder.GetBufferPointer(), into);
  } catch (const BadMessage& bad) {
    const Keeper here(builder.GetBufferPointer(), [](const void*) {});
    EXPECT_THROW(decode(builder.GetBufferPointer(), into, here), BadMessage) << "when viewed";
    return bad.what();
  }
  return "";
}

TEST(Codec, LoadArrivesAsItWasSent) {
  flatbuffers::FlatBufferBuilder builder;
  const Load sent = sample();
  encode(sent, builder);
  Load got;
  decode(builder.GetBufferPointer(), got);
  EXPECT_EQ(got.window, 17U);
  EXPECT_TRUE(std::isnan(got.downstream_level_m));
  EXPECT_EQ(got.holds_until_s, sent.holds_until_s);
  EXPECT_EQ(got.edge, sent.edge);
  EXPECT_EQ(got.pressure_to_pa, sent.pressure_to_pa);
  EXPECT_EQ(got.cracks_from, 1U);
  EXPECT_TRUE(got.breached);
  EXPECT_EQ(got.added_mass, sent.added_mass);
}

TEST(Codec, ALoadWithoutAddedMassHasNone) {
  flatbuffers::FlatBufferBuilder builder;
  Load sent = sample();
  sent.added_mass.clear();
  encode(sent, builder);
  Load got = sample();  // storage in use
  decode(builder.GetBufferPointer(), got);
  EXPECT_TRUE(got.added_mass.empty());
}

TEST(Codec, AnAddedMassThatIsNotANumberIsNamed) {
  Load load = sample();
  load.added_mass.own()[1][2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(load), "added mass 2 of block 1 is inf in window 17");
}

TEST(Codec, AddedMassesThatAreNotSixABlockAreRefused) {
  flatbuffers::FlatBufferBuilder builder;
  const auto added_mass = builder.CreateVector(std::vector<double>(7, 1.0));
  buffer::LoadBuilder load(builder);
  load.add_added_mass(added_mass);
  buffer::FinishEnvelopeBuffer(builder, buffer::CreateEnvelope(builder, buffer::Body::Load, load.Finish().Union()));
  Load into;
  try {
    decode(builder.GetBufferPointer(), into);
    FAIL() << "was read";
  } catch (const BadMessage& bad) {
    EXPECT_STREQ(bad.what(), "added mass holds 7 numbers, not 6 a block");
  }
}

TEST(Codec, MotionArrivesAsItWasSent) {
  flatbuffers::FlatBufferBuilder builder;
  Motion sent{.window = 3,
              .time_s = 0.5,
              .displacement = {{1, 2, 3, 4, 5, 6}, {7, 8, 9, 10, 11, 12}},
              .velocity = {{0, 0, 0, 0, 0, 1}, {}}};
  encode(sent, builder);
  Motion got;
  decode(builder.GetBufferPointer(), got);
  EXPECT_EQ(got.displacement, sent.displacement);
  EXPECT_EQ(got.velocity, sent.velocity);
}

TEST(Codec, APressureThatIsNotANumberIsNamed) {
  Load load = sample();
  load.pressure_to_pa.own()[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(load), "pressure of panel 1 (block 2, edge 0) is nan in window 17");
}

TEST(Codec, ColumnsStayInTheFrameThatIsKept) {
  auto builder = std::make_shared<flatbuffers::FlatBufferBuilder>();
  const Load sent = sample();
  encode(sent, *builder);
  const std::uint8_t* frame = builder->GetBufferPointer();
  const std::uint8_t* end = frame + builder->GetSize();
  const std::weak_ptr<flatbuffers::FlatBufferBuilder> kept = builder;
  Load got = sample();
  decode(frame, got, std::move(builder));
  const auto* pressure = reinterpret_cast<const std::uint8_t*>(got.pressure_to_pa.data());
  EXPECT_TRUE(frame <= pressure && pressure < end);
  EXPECT_EQ(got.pressure_to_pa, sent.pressure_to_pa);
  EXPECT_EQ(got.block, sent.block);
  EXPECT_EQ(got.added_mass, sent.added_mass);
  Load copy = got;
  got.pressure_to_pa.own()[1] = 5;  // of its own from now on
  EXPECT_EQ(got.pressure_to_pa, (Column<double>{3e4, 5}));
  EXPECT_EQ(copy.pressure_to_pa, sent.pressure_to_pa);
  got = Load();
  EXPECT_FALSE(kept.expired());  // the copy keeps it, too
  copy.release();
  EXPECT_TRUE(kept.expired());
}

TEST(Codec, PressuresThatHoldUntilNoTimeAreRefused) {
  Load load = sample();
  load.holds_until_s = std::nan("");
  EXPECT_EQ(refusal(load), "time that the pressures hold is nan in window 17");
}

TEST(Codec, ColumnsOfUnequalLengthAreRefused) {
  Load load = sample();
  load.s_to.own().pop_back();
  EXPECT_EQ(refusal(load), "columns of 2 and 1 panels in window 17");
}

TEST(Codec, CracksBeyondThePanelsAreRefused) {
  Load load = sample();
  load.cracks_from = 3;
  EXPECT_EQ(refusal(load), "cracks from panel 3 of 2 in window 17");
}

TEST(Codec, FractionsOutsideTheEdgeAreRefused) {
  Load load = sample();
  load.s_to.own()[0] = 1.5;
  EXPECT_THAT(refusal(load), testing::HasSubstr("end of panel 0 (block 1, edge 3) is 1.5"));
}

/// A load whose columns of doubles are parts, as it goes over the line.
class LargeLoad : public testing::Test {
 protected:
  LargeLoad() {
    for (std::size_t i = 0; i < 40'000; ++i) {
      load.block.push_back(static_cast<std::uint32_t>(i / 4));
      load.edge.push_back(static_cast<std::uint32_t>(i % 4));
      load.s_from.push_back(0);
      load.s_to.push_back(1);
      load.pressure_from_pa.push_back(static_cast<double>(i));
      load.pressure_to_pa.push_back(static_cast<double>(i + 1));
    }
    load.cracks_from = 40'000;
    load.window = 17;
    send();
  }
  void send() {
    parts.clear();
    encode(load, builder, &parts);
  }
  [[nodiscard]] Load received() {
    EXPECT_EQ(verify(builder.GetBufferPointer(), builder.GetSize()), Kind::load);
    Load into;
    std::size_t next = 0;
    decode(builder.GetBufferPointer(), into, nullptr, [&] { return next < parts.size() ? parts[next++] : Part(); });
    EXPECT_EQ(next, parts.size());
    return into;
  }
  [[nodiscard]] std::string refusal() {
    try {
      (void)received();
    } catch (const BadMessage& bad) {
      return bad.what();
    }
    return "";
  }
  /// The part's bytes, to be changed, in place of the part.
  std::vector<double>& altered(std::size_t part) {
    const auto* first = static_cast<const double*>(parts[part].data);
    auto own = std::make_shared<std::vector<double>>(first, first + parts[part].size / sizeof(double));
    parts[part] = {own->data(), parts[part].size, own};
    return *own;
  }

  Load load;
  flatbuffers::FlatBufferBuilder builder;
  std::vector<Part> parts;
};

TEST_F(LargeLoad, IsSentFromWhereItStandsAndReadWhereItArrives) {
  ASSERT_EQ(parts.size(), 4U);  // 320 kB each; the whole numbers' 160 kB go in the first frame
  EXPECT_EQ(parts[0].data, load.s_from.data());
  const Load got = received();
  EXPECT_EQ(got.block, load.block);
  EXPECT_EQ(got.edge, load.edge);
  EXPECT_EQ(got.s_from, load.s_from);
  EXPECT_EQ(got.s_to, load.s_to);
  EXPECT_EQ(got.pressure_from_pa, load.pressure_from_pa);
  EXPECT_EQ(got.pressure_to_pa, load.pressure_to_pa);
  EXPECT_EQ(got.pressure_to_pa.data(), parts[3].data);
}

TEST_F(LargeLoad, StaysAsItWasSentWhileItIsOnItsWay) {
  load.pressure_to_pa.own()[7] = -1;  // the next window's
  load.s_from.assign(3, 0.5);
  load.s_to.clear();
  const Load got = received();
  EXPECT_EQ(got.pressure_to_pa[7], 8);
  EXPECT_EQ(got.s_from.size(), 40'000U);
  EXPECT_EQ(got.s_to.size(), 40'000U);
  const double* before = load.pressure_to_pa.data();
  load.pressure_to_pa.own()[7] = -2;  // nobody else has these
  EXPECT_EQ(load.pressure_to_pa.data(), before);
}

TEST_F(LargeLoad, DamagedIsRefused) {
  altered(2)[30'000] += 1;
  EXPECT_EQ(refusal(), "320000 bytes that are damaged, or not the pressure_from_pa of window 17");
}

TEST_F(LargeLoad, OutOfOrderIsRefused) {
  std::swap(parts[2], parts[3]);
  EXPECT_EQ(refusal(), "320000 bytes that are damaged, or not the pressure_from_pa of window 17");
}

TEST_F(LargeLoad, CutShortIsRefused) {
  parts[3].size -= 8;
  EXPECT_EQ(refusal(), "319992 bytes of pressure_to_pa where 320000 were due, in window 17");
}

TEST_F(LargeLoad, WithoutAPartIsRefused) {
  parts.pop_back();
  EXPECT_EQ(refusal(), "no pressure_to_pa in window 17");
}

TEST_F(LargeLoad, ANumberThatCannotBeIsNamed) {
  load.pressure_to_pa.own()[39'999] = std::numeric_limits<double>::infinity();
  send();
  EXPECT_EQ(refusal(), "pressure of panel 39999 (block 9999, edge 3) is inf in window 17");
  load.pressure_to_pa.own()[39'999] = 0;
  load.s_from.own()[1] = -0.5;
  send();
  EXPECT_EQ(refusal(), "end of panel 1 (block 0, edge 1) is -0.5 in window 17");
}

std::vector<std::uint8_t> sound_frame() {
  flatbuffers::FlatBufferBuilder builder;
  encode(sample(), builder);
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

TEST(Codec, EveryFlippedBitIsSeen) {
  std::vector<std::uint8_t> bytes = sound_frame();
  ASSERT_EQ(verify(bytes.data(), bytes.size()), Kind::load);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    const auto flip = static_cast<std::uint8_t>(1U << bit % 8);
    bytes[bit / 8] ^= flip;
    EXPECT_THROW(verify(bytes.data(), bytes.size()), BadMessage) << bit;
    bytes[bit / 8] ^= flip;
  }
}

TEST(Codec, EveryTruncationIsSeen) {
  const std::vector<std::uint8_t> bytes = sound_frame();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(verify(bytes.data(), size), BadMessage) << size;
  }
}

TEST(Hello, EveryDifferenceIsNamedWithBothValues) {
  const Hello ours{.role = "solid", .scene_digest = "aa", .window_s = 0.01};
  const Hello theirs{.role = "hydrostatic", .scene_digest = "bb", .window_s = 0.02};
  EXPECT_EQ(channel::compare(ours, theirs),
            "scene digest: solid has aa, hydrostatic has bb; window_s: solid has 0.01, hydrostatic has 0.02");
  EXPECT_EQ(channel::compare(ours, ours), "");
}

}  // namespace
}  // namespace blockweir::wire
