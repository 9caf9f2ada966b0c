// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_limit bridge_scene_read
// Blocks that stand on one corner are told of, and any water turns them over.
#include "bridge/scene/corner_stands.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "bridge/scene/read/read.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/limit/limit_level.hpp"

namespace blockweir::scene::corner_stands_test {
namespace {

using solid::limit::Wrench;
using solid::limit::Wrenches;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A square of 2 m on its corner at the origin, turned so that one face has this angle to the rock.
std::string square(double angle_deg, const std::string& more = "") {
  const double angle = angle_deg * std::numbers::pi / 180;
  const Point along = 2 * Point(std::cos(angle), std::sin(angle));
  const Point up(-along.y(), along.x());
  const auto corner = [](const Point& p) { return fmt::format("[{:.9f}, {:.9f}]", p.x(), p.y()); };
  return fmt::format(R"(
analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 30 }}
material.stone = {{ youngs_modulus_pa = 1e10, poissons_ratio = 0.2, density_kg_per_m3 = 2000 }}
[[block]]
name = "rock"
material = "stone"
fixed = true
vertices_m = [[-9, -3], [9, -3], [9, 0], [-9, 0]]
[[block]]
name = "stone"
material = "stone"
vertices_m = [[0, 0], {}, {}, {}]
{})",
                     corner(along), corner(along + up), corner(up), more);
}

TEST(CornerStands, AreThoseOfSquaresThatAreTurned) {
  for (const double angle_deg : {0.0, 0.05, 0.5, 89.9}) {  // rounded coordinates
    EXPECT_THAT(corner_stands(read_text(square(angle_deg), "s.toml").scene), IsEmpty()) << angle_deg;
  }
  for (const double angle_deg : {3.0, 20.0, 45.0, 80.0}) {
    const auto read = read_text(square(angle_deg), "s.toml");
    ASSERT_THAT(corner_stands(read.scene), SizeIs(1)) << angle_deg;
    EXPECT_EQ(corner_stands(read.scene)[0].block, 1);
    EXPECT_LT(corner_stands(read.scene)[0].at_m.norm(), 1e-6);
    EXPECT_THAT(read.scene.warnings,
                testing::Contains(HasSubstr("block \"stone\" touches other blocks at one corner alone, at (0, 0) m")));
  }
}

TEST(CornerStands, WhatSomethingElseHoldsIsNone) {
  for (const char* holds :
       {"[[support]]\nblock = 'stone'\npoint_m = [0, 0]\ndisplacement_x_m = 0\n",
        "[[bolt]]\nname = 'a'\nfrom_block = 'stone'\nfrom_m = [0, 1]\nto_m = [0, -2]\nyoungs_modulus_pa = 2e11\n"
        "area_m2_per_m = 1e-3\n",
        "[[block]]\nname = 'beside'\nmaterial = 'stone'\nvertices_m = [[1.41421356, 0], [3, 0], [3, 2], [1.41421356, "
        "2]]\n"}) {
    const auto read = read_text(square(45, holds), "s.toml");
    EXPECT_THAT(corner_stands(read.scene), IsEmpty()) << holds;
    EXPECT_THAT(read.scene.warnings, testing::Not(testing::Contains(HasSubstr("one corner")))) << holds;
  }
}

/// Its level of failure is where the water begins to push, not the reservoir's empty level below.
TEST(CornerStands, AnyPushTurnsThemOver) {
  const Scene scene = read_text(square(45), "s.toml").scene;
  const auto pushes = [&](double level_m) {
    const double head_m = std::max(0.0, level_m);
    Wrenches forces(scene.blocks.size(), Wrench::Zero());
    forces[1] = solid::limit::wrench_of({9810 * head_m * head_m / 2, 0}, {0, head_m / 3}, {0, std::sqrt(2.0)});
    return forces;
  };
  const auto found = limit_level(solid::limit::LimitAnalysis(scene), statics::weights_of(scene), pushes, {-3, 2.8});
  EXPECT_EQ(found.outcome, solid::limit::Filled::fails);
  EXPECT_NEAR(found.level_m, 0, 1e-4);
}

}  // namespace
}  // namespace blockweir::scene::corner_stands_test
