// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture nlohmann_json::nlohmann_json
// The picture of a mechanism shows the structure, not all of the rock that it stands on.
#include <gtest/gtest.h>

#include "bridge/picture/mechanism.hpp"

namespace blockweir::picture::mechanism_view_test {
namespace {

using nlohmann::json;
using scene::Point;

/// A dam of 10 by 20 m on 200 m of rock that can move.
scene::Scene dam_on_rock() {
  scene::Scene scene;
  const auto add = [&](const char* name, const Point& low, const Point& high) {
    scene::Block block;
    block.name = name;
    block.vertices = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    scene.blocks.push_back(block);
  };
  add("rock", {-100, -40}, {100, 0});
  add("dam", {0, 0}, {10, 20});
  return scene;
}

json mechanism_of(const char* block) {
  return {{"blocks", {{{"name", block}, {"velocity_x", 1}, {"velocity_y", 0}, {"spin_per_m", 0}}}}};
}

TEST(MechanismView, ShowsTheDamAndAThirdOfItsSizeAround) {
  const geometry::Bounds view = mechanism_view(dam_on_rock(), mechanism_of("dam"));
  EXPECT_NEAR(view.low.x(), -20.0 / 3, 1e-9);
  EXPECT_NEAR(view.high.x(), 10 + 20.0 / 3, 1e-9);
  EXPECT_NEAR(view.low.y(), -20.0 / 3, 1e-9);
  EXPECT_NEAR(view.high.y(), 20 + 20.0 / 3, 1e-9);
}

TEST(MechanismView, WhatDilationLiftsHasACaption) {
  EXPECT_EQ(mechanism_title({{"text", "block slides"}}), "'block slides'");
  EXPECT_EQ(mechanism_title({{"text", "block slides"}, {"caption", "joints open"}}),
            "'block slides'.\"\\n\".'joints open'");
}

TEST(MechanismView, ShowsTheRockWhereItMoves) {
  const geometry::Bounds view = mechanism_view(dam_on_rock(), mechanism_of("rock"));
  EXPECT_LT(view.low.x(), -100);
  EXPECT_GT(view.high.y(), 20);
}

}  // namespace
}  // namespace blockweir::picture::mechanism_view_test
