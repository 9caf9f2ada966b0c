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
    EXPECT_STREQ(bad.what(), "added mass holds 7 numbers, not six a block");
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
