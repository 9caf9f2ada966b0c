// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// Silt is drawn up to its level before the dam, and nowhere else.
#include "bridge/picture/silt.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "bridge/geometry/polygon.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::picture::silt_test {
namespace {

using nlohmann::json;

constexpr View view{-10, 10, -2, 8};

/// A wall of 6 m from x = 0 to 2 on level ground, a reservoir and a tailwater.
json wall(double upstream_m, double downstream_m) {
  return {{"upstream_level_m", upstream_m},
          {"downstream_level_m", downstream_m},
          {"blocks",
           {{{"fixed", true}, {"outline", {{-10, -1}, {10, -1}, {10, 0}, {-10, 0}}}},
            {{"fixed", false}, {"outline", {{0, 0}, {2, 0}, {2, 6}, {0, 6}}}}}},
          {"panels",
           {{-10, 0, 0, 0, 1, 1, 0},
            {0, upstream_m, 0, 0, 0, 1, 0},
            {2, 0, 2, downstream_m, 1, 0, 0},
            {2, 0, 10, 0, 1, 1, 0}}}};
}

TEST(Silt, LiesUpToItsLevelUpstreamAloneWhateverTheWaterDoes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> height(0.5, 5.5);
  for (int trial = 0; trial < 40; ++trial) {
    const double level_m = height(random);
    const auto bodies = silt_bodies(wall(height(random), height(random)), level_m, view);
    ASSERT_EQ(bodies.size(), 1U);
    EXPECT_NEAR(geometry::signed_area(bodies[0]), 10 * level_m, 0.02 * (10 + level_m));  // of gaps that are closed
    for (const Eigen::Vector2d& p : bodies[0]) {
      EXPECT_LE(p.x(), 0);
      EXPECT_LE(p.y(), level_m + 1e-6);
    }
  }
}

class SiltLevel : public test::OwnFolder {};

TEST_F(SiltLevel, IsThatOfTheScenesFile) {
  const auto of = [&](const std::string& text) {
    std::ofstream(folder / "scene.toml") << text;
    return silt_level_m(folder / "scene.toml");
  };
  EXPECT_EQ(of("[silt]\nlevel_m = 3\n"), 3);
  EXPECT_EQ(of("silt = { level_m = 2.5 }\n"), 2.5);
  EXPECT_EQ(of("title = 'none'\n"), std::nullopt);
  EXPECT_EQ(silt_level_m(folder / "no-such.toml"), std::nullopt);
}

}  // namespace
}  // namespace blockweir::picture::silt_test
