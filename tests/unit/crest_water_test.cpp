// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_block
// Two pools above the crest: what presses on it is continuous in both levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/still_water.hpp"

namespace blockweir::hydrostatic::crest_water_test {
namespace {

using tests::load_at_rest;
using tests::Resultant;
using tests::resultant;
using tests::scene_of;

const std::vector<Point> rock = {{-20, -3}, {30, -3}, {30, 0}, {-20, 0}};

Resultant on_wall(const std::vector<Point>& wall, double upstream_m, double downstream_m,
                  scene::CrestPressure law = scene::CrestPressure::none) {
  auto scene = scene_of({rock, wall}, upstream_m);
  scene.water.crest_pressure = law;
  scene.water.downstream_level_m = scene::TimeTable::constant(downstream_m);
  return resultant(scene, load_at_rest(scene), 1);
}

using scene::CrestPressure;

/// On a crest of 4 m at 5 m stands the lower pool, and above it what the law says of the reservoir's nappe.
TEST(CrestWater, IsTheLowerPoolsAndAboveItTheNappes) {
  const std::vector<Point> wall = {{0, 0}, {4, 0}, {4, 5}, {0, 5}};
  for (const auto law : {CrestPressure::none, CrestPressure::triangular, CrestPressure::full}) {
    for (const auto& [up, down] : {std::pair{6.0, 5.5}, {5.5, 6.0}, {6.0, 6.0 - 1e-9}, {6.0, 6.0}, {6.0, 5 + 1e-9}}) {
      const Resultant r = on_wall(wall, up, down, law);
      const double lower = 9810 * (std::min(up, down) - 5);
      const double from = law == CrestPressure::none || down > up ? lower : 9810 * (up - 5);
      const double to = law == CrestPressure::full ? from : lower;
      EXPECT_NEAR(r.force.y(), -(from + to) / 2 * 4, 1e-6) << up << ' ' << down;
      const auto side = [](double level) { return 9810 * (level * 25 / 2 - 125.0 / 3); };  // about the foot
      EXPECT_NEAR(r.moment, -(from + 2 * to) / 6 * 16 + side(down) - side(up), 1e-6) << up << ' ' << down;
    }
  }
}

/// Either pool reaches the crest while the other one stands above it, at random; level crests, and faces that lean in.
/// (Of one that leans out the wall on the crest's corner hides 1e-5 of the model.)
TEST(CrestWater, NoLoadJumpsAsAPoolPassesTheCrest) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
  for (int i = 0; i < 60; ++i) {
    const auto law = std::array{CrestPressure::none, CrestPressure::triangular, CrestPressure::full}[random() % 3];
    const std::vector<Point> wall = {{0, 0}, {6, 0}, {6 - between(0, 1), 5}, {between(0, 1), 5}};
    const double other = between(5.1, 9);
    const double off = 1e-7;
    for (const bool upstream_passes : {false, true}) {
      const auto load = [&](double level) {
        return upstream_passes ? on_wall(wall, level, other, law) : on_wall(wall, other, level, law);
      };
      const Resultant below = load(5 - off);
      const Resultant above = load(5 + off);
      EXPECT_LE((above.force - below.force).norm(), 9810 * 30 * off) << i;
      EXPECT_LE(std::abs(above.moment - below.moment), 9810 * 30 * 10 * off) << i;
    }
  }
}

TEST(CrestWater, WithoutASecondPoolOverTheCrestThereIsNone) {
  const std::vector<Point> wall = {{0, 0}, {4, 0}, {4, 5}, {0, 5}};
  EXPECT_NEAR(on_wall(wall, 6, 4.9).force.y(), 0, 1e-9);
  EXPECT_NEAR(on_wall(wall, 4.9, 6).force.y(), 0, 1e-9);
}

/// A crest of battlements, of a peak or that tilts a little; faces that lean in or out.
TEST(CrestWater, LevelsThatAreAllButEqualPressAsEqualOnesDo) {
  std::mt19937 random(28);
  const auto between = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
  for (int i = 0; i < 60; ++i) {
    const double lean_up = between(-1, 1);
    const double lean_down = between(-1, 1);
    std::vector<Point> wall = {{0, 0}, {6, 0}, {6 + lean_down, 5}};
    switch (i % 4) {
      case 0:
        break;
      case 1:
        wall.insert(wall.end(), {{5, 5}, {between(4, 5), between(2, 4)}, {between(1, 3), between(2, 4)}, {1, 5}});
        break;
      case 2:
        wall.emplace_back(3, between(5.1, 5.8));
        break;
      default:
        wall.back().y() += between(-5e-3, 5e-3);
    }
    wall.emplace_back(lean_up, 5);
    const double level = between(6, 9);
    const Resultant equal = on_wall(wall, level, level);
    const double off = 1e-7;
    const auto law = std::array{CrestPressure::none, CrestPressure::triangular, CrestPressure::full}[random() % 3];
    for (const auto& [up, down] : {std::pair{level + off, level}, {level, level + off}, {level - off, level}}) {
      const Resultant r = on_wall(wall, up, down, law);
      EXPECT_LE((r.force - equal.force).norm(), 9810 * 30 * off) << i;
      EXPECT_LE(std::abs(r.moment - equal.moment), 9810 * 30 * 10 * off) << i;
    }
  }
}

}  // namespace
}  // namespace blockweir::hydrostatic::crest_water_test
