// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_fluid bridge_channel
// Any calls of the C interface, in any order, with any numbers: what is wrong is refused in a line, and the solid hears
// of it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "blockweir_fluid.h"
#include "bridge/channel/channel.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::test::kit_calls_test {
namespace {

using testing::HasSubstr;

/// A square and a triangle.
wire::Hello hello() {
  wire::Hello hello;
  hello.role = "solid";
  hello.build = "test";
  hello.scene_digest = "0123456789abcdef";
  hello.schedule = "serial";
  hello.units = "SI per metre";
  hello.window_s = 0.1;
  hello.duration_s = 1;
  hello.block_names = {"square", "triangle"};
  hello.vertex_counts = {4, 3};
  hello.vertices_m = {0, 0, 1, 0, 1, 1, 0, 1, 2, 0, 3, 0, 2, 1};
  return hello;
}

class KitCalls : public OwnFolder {
 protected:
  KitCalls() : endpoint("ipc://" + (folder / "line").string()) {}

  /// Motions until the fluid has had enough; what it then says.
  std::string solid(std::uint64_t motions) const {
    try {
      channel::Channel line({channel::Side::listens, endpoint, "fluid", 5, 5});
      line.handshake(hello());
      wire::Motion motion;
      wire::Load load;
      motion.displacement.assign(2, {0.1, 0, 0, 0, 0, 0});
      motion.velocity.assign(2, {});
      for (motion.window = 0; motion.window < motions; ++motion.window) {
        motion.time_s = 0.1 * static_cast<double>(motion.window);
        motion.order = static_cast<wire::Order>(motion.window % 3 == 2 ? 1 : 0);
        line.send(motion);
        line.receive(load);
      }
      line.send(wire::Farewell{"complete"});
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
  /// What the fluid and the solid say where the fluid answers its first motion with `load`.
  std::pair<std::string, std::string> refusal(const blockweir_load& load) const {
    std::string heard;
    std::thread other([&] { heard = solid(1); });
    blockweir_fluid* fluid = blockweir_open("fuzz", endpoint.c_str());
    blockweir_motion motion;
    EXPECT_EQ(blockweir_receive(fluid, &motion), BLOCKWEIR_MOTION) << blockweir_error(fluid);
    EXPECT_EQ(blockweir_send(fluid, &load), BLOCKWEIR_ERROR);
    EXPECT_EQ(blockweir_send(fluid, &load), BLOCKWEIR_ERROR) << "and nothing goes on";
    const std::string said = blockweir_error(fluid);
    EXPECT_EQ(blockweir_close(fluid), 1);
    other.join();
    return {said, heard};
  }
  std::string endpoint;
};

struct Panel {
  std::uint32_t block = 0;
  std::uint32_t edge = 3;
  double s_from = 0;
  double s_to = 1;
  double pressure_from_pa = 1;
  double pressure_to_pa = 2;

  [[nodiscard]] blockweir_load load() const {
    blockweir_load load = blockweir_dry();
    load.panels = load.cracks_from = 1;
    load.block = &block;
    load.edge = &edge;
    load.s_from = &s_from;
    load.s_to = &s_to;
    load.pressure_from_pa = &pressure_from_pa;
    load.pressure_to_pa = &pressure_to_pa;
    return load;
  }
};

TEST_F(KitCalls, WhatCannotBeIsNamedToBothSides) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<Panel, std::string>> wrong = {
      {{.block = 2}, "panel 0 is of block 2; the scene has 2, in window 0"},
      {{.block = 1, .edge = 3}, "panel 0 is of edge 3 of block 1, which has 3, in window 0"},
      {{.s_from = -0.1}, "s_from of panel 0 is -0.1, not from 0 to 1, in window 0"},
      {{.s_to = nan}, "s_to of panel 0 is nan, not from 0 to 1, in window 0"},
      {{.s_from = 0.5, .s_to = 0.25}, "s_to of panel 0 is 0.25, before its s_from, in window 0"},
      {{.pressure_to_pa = nan}, "pressure of panel 0 is nan, in window 0"}};
  for (const auto& [panel, why] : wrong) {
    const auto [said, heard] = refusal(panel.load());
    EXPECT_EQ(said, why);
    EXPECT_THAT(heard, HasSubstr(why));
  }
  const Panel sound;
  blockweir_load load = sound.load();
  load.edge = nullptr;
  EXPECT_EQ(refusal(load).first, "a load of 1 panels with a column that is NULL, in window 0");
  load = sound.load();
  load.cracks_from = 2;
  EXPECT_EQ(refusal(load).first, "cracks from panel 2 of 1, in window 0");
  load = sound.load();
  load.upstream_level_m = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(load).first, "a level that is infinite, in window 0");
}

TEST_F(KitCalls, WithoutAnEndpointOrASolidSayWhatIsMissing) {
  blockweir_fluid* fluid = blockweir_open("fuzz", "");
  EXPECT_THAT(blockweir_error(fluid), HasSubstr("no endpoint: set BLOCKWEIR_ENDPOINT"));
  blockweir_motion motion;
  EXPECT_EQ(blockweir_receive(fluid, &motion), BLOCKWEIR_ERROR);
  EXPECT_EQ(blockweir_blocks(fluid), 0U);
  EXPECT_STREQ(blockweir_block_name(fluid, 7), "");
  EXPECT_EQ(blockweir_outline(fluid, 0), nullptr);
  EXPECT_EQ(blockweir_close(fluid), 1);
  fluid = blockweir_open("fuzz", "nonsense");
  EXPECT_THAT(blockweir_error(fluid), HasSubstr("expected ipc://PATH or tcp://HOST:PORT"));
  blockweir_close(fluid);
  EXPECT_EQ(blockweir_close(nullptr), 1);
}

/// Calls at random; the run ends, well or not, and nothing else does.
TEST_F(KitCalls, InAnyOrderWithAnyNumbersEndInOrder) {
  std::mt19937 random(31);
  const auto any = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  const double numbers[] = {0, 1, 0.5, -1, 1e300, std::nan(""), std::numeric_limits<double>::infinity(), 5e-324};
  const auto number = [&] { return any(9) > 0 ? 0.5 : numbers[any(7)]; };
  int complete = 0;
  for (int trial = 0; trial < 60; ++trial) {
    std::string heard;
    std::thread other([&] { heard = solid(6); });
    blockweir_fluid* fluid = blockweir_open(any(5) > 0 ? "fuzz" : nullptr, endpoint.c_str());
    if (any(1) > 0) blockweir_remembers(fluid);
    blockweir_motion motion{};
    int status = BLOCKWEIR_MOTION;
    while (status > 0) {
      status = blockweir_receive(fluid, any(60) > 0 ? &motion : nullptr);
      if (status == BLOCKWEIR_SAVE && any(3) > 0) continue;
      double xy[8];
      const auto block = static_cast<size_t>(any(2));
      if (blockweir_place(fluid, block, xy) == BLOCKWEIR_OK) EXPECT_LT(block, 2U);
      Panel panel{any(30) > 0 ? 1U : 9U, static_cast<std::uint32_t>(any(2)), 0, number(), number(), number()};
      blockweir_load load = any(3) > 0 ? panel.load() : blockweir_dry();
      if (any(20) == 0) load.holds_until_s = number();
      if (any(20) == 0) load.upstream_level_m = number();
      if (status == BLOCKWEIR_MOTION && any(40) > 0) blockweir_send(fluid, &load);
      if (any(20) == 0) blockweir_progress(fluid, any(1) > 0 ? "on the way" : nullptr);
      if (any(60) == 0) blockweir_fail(fluid, any(1) > 0 ? "had enough" : nullptr);
    }
    const std::string said = blockweir_error(fluid);
    const int ended = blockweir_close(fluid);
    EXPECT_EQ(ended == 0, said.empty()) << said;
    other.join();
    if (ended == 0) EXPECT_EQ(heard, "");
    if (!heard.empty()) EXPECT_THAT(heard, HasSubstr(said));  // else the solid was done already
    complete += ended == 0 ? 1 : 0;
  }
  EXPECT_GT(complete, 3);
  EXPECT_LT(complete, 57);
}

}  // namespace
}  // namespace blockweir::test::kit_calls_test
