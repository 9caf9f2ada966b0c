// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_channel
// Messages survive the wire; what is no message, or says what cannot be, is refused by name.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "bridge/channel/handshake.hpp"
#include "bridge/wire/checksum.hpp"
#include "bridge/wire/codec.hpp"
#include "bridge/wire/messages_generated.h"
#include "tests/unit/wire_sample.hpp"

namespace blockweir::wire::wire_codec_test {
namespace {

template <class Message>
std::string refusal(const Message& message) {
  const Sent sent(message);
  Message into;
  try {
    EXPECT_EQ(verify(sent.frame()), (std::is_same_v<Message, Load> ? Kind::load : Kind::motion));
    decode(sent.frame(), into);
  } catch (const BadMessage& bad) {
    const Keeper here(&sent, [](const void*) {});
    EXPECT_THROW(decode(sent.frame(here), into), BadMessage) << "when viewed";
    return bad.what();
  }
  return "";
}

TEST(Codec, LoadArrivesAsItWasSent) {
  const Load sent = sample_load();
  Load got;
  decode(Sent(sent).frame(), got);
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
  Load sent = sample_load();
  sent.added_mass.clear();
  Load got = sample_load();  // storage in use
  decode(Sent(sent).frame(), got);
  EXPECT_TRUE(got.added_mass.empty());
}

TEST(Codec, AnAddedMassThatIsNotANumberIsNamed) {
  Load load = sample_load();
  load.added_mass.own()[1][2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(load), "added mass 2 of block 1 is inf in window 17");
}

TEST(Codec, AddedMassesBetweenBlocksArriveWhereThereAreAny) {
  Load sent = sample_load();
  Load got = sample_load();
  decode(Sent(sent).frame(), got);
  EXPECT_TRUE(got.coupled.empty());
  sent.coupled = {{0, 2}, {1, 2}};
  sent.added_mass_between = {{1, 2, 3, 4, 5, 6, 7, 8, 9}, {-1, 0, 0, 0, -1, 0, 0, 0, -1}};
  decode(Sent(sent).frame(), got);
  EXPECT_EQ(got.coupled, sent.coupled);
  EXPECT_EQ(got.added_mass_between, sent.added_mass_between);
  EXPECT_EQ(got.edge, sent.edge);
  decode(Sent(sample_load()).frame(), got);
  EXPECT_TRUE(got.coupled.empty());
  EXPECT_TRUE(got.added_mass_between.empty());
}

TEST(Codec, AddedMassesBetweenBlocksThatAreNotOneAPairOrNoNumbersAreRefused) {
  Load load = sample_load();
  load.coupled = {{0, 2}, {1, 2}};
  load.added_mass_between = {{1, 2, 3, 4, 5, 6, 7, 8, 9}};
  EXPECT_EQ(refusal(load), "2 pairs of blocks and 1 added masses between them in window 17");
  load.added_mass_between = {{}, {0, 0, std::nan(""), 0, 0, 0, 0, 0, 0}};
  EXPECT_EQ(refusal(load), "an added mass between blocks that is not finite in window 17");
}

/// What a reader says of a frame whose table tells of other columns than it holds.
std::string refusal_of_told(const Load& load, const std::function<void(buffer::ColumnSum*)>& alter) {
  const Sent sent(load);
  auto* columns = const_cast<flatbuffers::Vector<const buffer::ColumnSum*>*>(
      buffer::GetEnvelope(sent.builder.GetBufferPointer())->body_as_Load()->columns());
  alter(reinterpret_cast<buffer::ColumnSum*>(columns->Data()));
  Load into;
  try {
    decode(sent.frame(), into);
  } catch (const BadMessage& bad) {
    return bad.what();
  }
  return "";
}

TEST(Codec, AddedMassesThatAreNotSixABlockAreRefused) {
  Load load = sample_load();
  load.pressure_to_pa = {0, 1, 2, 3, 4, 5, 6};
  load.added_mass.clear();
  // The table gets to say that these are the added masses, which stand behind them.
  EXPECT_EQ(refusal_of_told(load, [](buffer::ColumnSum* told) { std::swap(told[3], told[4]); }),
            "added mass holds 7 numbers, not 6 a block");
}

TEST(Codec, AFrameThatHoldsLessOrMoreThanItsTableSaysIsRefused) {
  EXPECT_EQ(refusal_of_told(sample_load(),
                            [](buffer::ColumnSum* told) {
                              told[6] = {16, told[6].sum()};
                            }),
            "no edge in window 17");
  EXPECT_EQ(refusal_of_told(sample_load(),
                            [](buffer::ColumnSum* told) {
                              told[6] = {0, checksum(nullptr, 0)};
                            }),
            "8 bytes more than its header states in window 17");
}

TEST(Codec, MotionArrivesAsItWasSent) {
  Motion sent{.window = 3,
              .time_s = 0.5,
              .displacement = {{1, 2, 3, 4, 5, 6}, {7, 8, 9, 10, 11, 12}},
              .velocity = {{0, 0, 0, 0, 0, 1}, {}}};
  Motion got;
  decode(Sent(sent).frame(), got);
  EXPECT_EQ(got.displacement, sent.displacement);
  EXPECT_EQ(got.velocity, sent.velocity);
}

TEST(Codec, AMotionOfAnotherOrderIsRefused) {
  EXPECT_EQ(refusal(Motion{.window = 3, .order = static_cast<Order>(9)}), "order 9 in window 3");
}

TEST(Codec, AMotionAtNoTimeIsRefused) {
  EXPECT_EQ(refusal(Motion{.window = 3, .time_s = std::nan("")}), "time is nan in window 3");
}

TEST(Codec, DisplacementsAndVelocitiesOfUnequalNumberAreRefused) {
  EXPECT_EQ(refusal(Motion{.window = 3, .displacement = {{}, {}}, .velocity = {{}}}),
            "2 displacements and 1 velocities");
}

TEST(Codec, APressureThatIsNotANumberIsNamed) {
  Load load = sample_load();
  load.pressure_to_pa.own()[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(load), "pressure of panel 1 (block 2, edge 0) is nan in window 17");
}

TEST(Codec, ColumnsStayInTheFrameThatIsKept) {
  const Load sent = sample_load();
  auto memory = std::make_shared<Sent<Load>>(sent);
  const std::uint8_t* frame = memory->builder.GetBufferPointer();
  const std::uint8_t* end = frame + memory->builder.GetSize();
  const std::weak_ptr<Sent<Load>> kept = memory;
  Load got = sample_load();
  decode({frame, memory->builder.GetSize(), std::move(memory)}, got);
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
  Load load = sample_load();
  load.holds_until_s = std::nan("");
  EXPECT_EQ(refusal(load), "time that the pressures hold is nan in window 17");
}

TEST(Codec, ColumnsOfUnequalLengthAreRefused) {
  Load load = sample_load();
  load.s_to.own().pop_back();
  EXPECT_EQ(refusal(load), "columns of 2 and 1 panels in window 17");
}

TEST(Codec, CracksBeyondThePanelsAreRefused) {
  Load load = sample_load();
  load.cracks_from = 3;
  EXPECT_EQ(refusal(load), "cracks from panel 3 of 2 in window 17");
}

TEST(Codec, FractionsOutsideTheEdgeAreRefused) {
  Load load = sample_load();
  load.s_to.own()[0] = 1.5;
  EXPECT_THAT(refusal(load), testing::HasSubstr("end of panel 0 (block 1, edge 3) is 1.5"));
}

TEST(Codec, APanelThatRunsBackwardsIsNamed) {
  Load load = sample_load();
  load.s_from.own()[1] = 1;
  EXPECT_EQ(refusal(load), "");  // to a point
  load.s_to.own()[1] = 0.75;
  EXPECT_EQ(refusal(load), "s_to of panel 1 (block 2, edge 0) is 0.75 in window 17, before its s_from of 1");
}

TEST(Hello, EveryDifferenceIsNamedWithBothValues) {
  const Hello ours{.role = "solid", .scene_digest = "aa", .window_s = 0.01};
  const Hello theirs{.role = "hydrostatic", .scene_digest = "bb", .window_s = 0.02};
  EXPECT_EQ(
      channel::compare(ours, theirs),
      "scene digest: solid has aa, hydrostatic has bb; window_s: solid has 0.01, hydrostatic has 0.02; the two have "
      "read different scenes: give both the same scene file and the same --set");
  EXPECT_EQ(channel::compare(ours, ours), "");
}

}  // namespace
}  // namespace blockweir::wire::wire_codec_test
