// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic bridge_scene_read
// Silt, ice, earthquake and the nappe on a dam, as forces and moments by hand.
#include <fmt/format.h>

#include "bridge/statics/loads.hpp"
#include "fluid/hydrostatic/hydrostatic_model.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::reservoir_loads_test {
namespace {

using geometry::Point;
using scene::read_text;
using scene::sample::errors;
using testing::HasSubstr;

/// A dam of 20 m with this upstream foot, on rock at height 0.
std::string dam(double foot_x, const std::string& rest) {
  return fmt::format(R"([analysis]
duration_s = 1
[material.m]
youngs_modulus_pa = 20e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-40, -5], [60, -5], [60, 0], [-40, 0]]
[[block]]
name = "dam"
material = "m"
vertices_m = [[{}, 0], [15, 0], [4, 20], [0, 20]]
{})",
                     foot_x, rest);
}

/// Force of the water at time 0 on the dam [N], and its moment about the origin.
statics::Wrench water_on_dam(const scene::Scene& scene) {
  hydrostatic::HydrostaticModel water(scene);
  wire::Motion drawn;
  drawn.displacement.assign(2, {});
  drawn.velocity.assign(2, {});
  wire::Load load;
  water.advance(drawn, 0, load);
  statics::Wrench w = statics::water_forces(scene, load)[1];
  w[2] += geometry::cross(statics::centroids_of(scene)[1], w.head<2>());
  return w;
}

/// What a table adds to the water at this level.
statics::Wrench added_by(const std::string& table, double foot_x, double level_m, const std::string& more = "") {
  const std::string water = fmt::format("[water]\nupstream_level_m = {}\n{}", level_m, more);
  return water_on_dam(read_text(dam(foot_x, water + table), "s.toml").scene) -
         water_on_dam(
             read_text(dam(foot_x, fmt::format("[water]\nupstream_level_m = {}\nmay_overtop = true\n", level_m)),
                       "s.toml")
                 .scene);
}

void expect_wrench(const statics::Wrench& w, double x, double y, double moment) {
  const double scale = std::abs(x) + std::abs(y);
  EXPECT_NEAR(w[0], x, 1e-9 * scale);
  EXPECT_NEAR(w[1], y, 1e-9 * scale);
  EXPECT_NEAR(w[2], moment, 1e-8 * scale * 20);
}

TEST(ReservoirLoads, NoPanelEndsBeyondItsEdgeAtAnyLevel) {
  for (const double foot_x : {0.0, -1.7, -3.1}) {
    for (double level_m = 1; level_m < 20; level_m += 0.0937) {
      const auto scene = read_text(
          dam(foot_x, fmt::format("[water]\nupstream_level_m = {}\n[ice]\nthrust_n_per_m = 1e5\nthickness_m = "
                                  "0.6\n[earthquake]\nhorizontal_coefficient = 0.1\n",
                                  level_m)),
          "s.toml");
      hydrostatic::HydrostaticModel water(scene.scene);
      wire::Motion drawn;
      drawn.displacement.assign(2, {});
      drawn.velocity.assign(2, {});
      wire::Load load;
      water.advance(drawn, 0, load);
      for (std::size_t i = 0; i < load.block.size(); ++i) {
        ASSERT_GE(load.s_from[i], 0) << foot_x << ' ' << level_m;
        ASSERT_LE(load.s_to[i], 1) << foot_x << ' ' << level_m;
      }
    }
  }
}

/// The heel of a slab below a dam that has moved by a hair, wet over less than a rounding of its height.
TEST(ReservoirLoads, AFaceThatHardlyLooksUpstreamHasAFinitePressure) {
  std::string text = dam(0, R"([[block]]
name = "slab"
material = "m"
vertices_m = [[0, -4], [42, -4], [42, 0], [0, 0]]
[water]
upstream_level_m = 13.7
[earthquake]
horizontal_coefficient = 0.1
)");
  const std::string level_rock = "[60, 0], ";
  text.insert(text.find(level_rock) + level_rock.size(), "[42, 0], [42, -4], [0, -4], [0, 0], ");
  const auto scene = read_text(text, "s.toml");
  hydrostatic::HydrostaticModel water(scene.scene);
  wire::Motion moved;
  moved.displacement.assign(3, {});
  moved.velocity.assign(3, {});
  for (double turn = 1e-10; turn < 1e-4; turn *= 1.7) {
    for (double hair_m = 1e-10; hair_m < 1e-2; hair_m *= 3.1) {
      moved.displacement.own()[1] = {hair_m, -21 * turn, 0, 0, 0, 0};
      moved.displacement.own()[2] = {0, 0, turn, 0, 0, 0};
      wire::Load load;
      water.advance(moved, 0, load);
      for (std::size_t i = 0; i < load.block.size(); ++i) {
        ASSERT_TRUE(std::isfinite(load.pressure_from_pa[i])) << turn << ' ' << hair_m;
        ASSERT_TRUE(std::isfinite(load.pressure_to_pa[i])) << turn << ' ' << hair_m;
        ASSERT_GE(load.s_from[i], 0) << turn << ' ' << hair_m;
        ASSERT_LE(load.s_to[i], 1) << turn << ' ' << hair_m;
      }
    }
  }
}

TEST(ReservoirLoads, WestergaardsPressureHasHisForceAndMoment) {
  const double weight = 9810;
  const double h = 16;
  expect_wrench(added_by("[earthquake]\nhorizontal_coefficient = 0.1\n", 0, h), 7.0 / 12 * 0.1 * weight * h * h, 0,
                -7.0 / 30 * 0.1 * weight * h * h * h);
  expect_wrench(added_by("[earthquake]\nhorizontal_coefficient = 0.1\nadded_water_pressure = 'none'\n", 0, h), 0, 0, 0);
}

/// A face that leans has the normal part of the acceleration, square to it.
TEST(ReservoirLoads, WestergaardsPressureOnALeaningFaceIsOfItsNormalsPart) {
  const double h = 20 - 1e-9;
  const double lean = 4.0 / 20;
  const double nx = 1 / std::hypot(1, lean);
  const statics::Wrench w = added_by("[earthquake]\nhorizontal_coefficient = 0.1\n", -4, h);
  EXPECT_NEAR(w[0] / (7.0 / 12 * 0.1 * 9810 * h * h * nx), 1, 1e-8);
  EXPECT_NEAR(w[1] / w[0], -lean, 1e-8);
}

/// With the depth of the tailwater; the downstream face leans by 11 in 20.
TEST(ReservoirLoads, WestergaardsPressureIsTakenFromTheTailwater) {
  const double nx = 1 / std::hypot(1, 11.0 / 20);
  for (const double h : {5.0, 14.0, 16.0}) {  // the last as high as the reservoir
    const std::string water = fmt::format("[water]\nupstream_level_m = 16\ndownstream_level_m = {}\n", h);
    const auto with = [&](const char* k) { return water_on_dam(read_text(dam(0, water + k), "s.toml").scene)[0]; };
    const double added = with("[earthquake]\nhorizontal_coefficient = 0.1\n") - with("");
    EXPECT_NEAR(added / (7.0 / 12 * 0.1 * 9810 * (16 * 16 + h * h * nx)), 1, 1e-8) << h;
  }
}

TEST(ReservoirLoads, AnEarthquakePushesAllThatCanMove) {
  const auto scene =
      read_text(dam(0, "[earthquake]\nhorizontal_coefficient = 0.1\nvertical_coefficient = 0.05\n"), "s.toml").scene;
  const statics::Wrenches loads = statics::stated_loads_of(scene, 0);
  const double weight = -statics::weights_of(scene)[1][1];
  EXPECT_NEAR(loads[1][0] / weight, 0.1, 1e-12);
  EXPECT_NEAR(loads[1][1] / weight, 0.05, 1e-12);
  EXPECT_EQ(loads[0][0], 0);
}

TEST(ReservoirLoads, IceActsUnderTheLevelAndFollowsIt) {
  const std::string ice = "[ice]\nthrust_n_per_m = 150e3\nthickness_m = 0.8\n";
  for (const double level : {12.0, 18.5}) expect_wrench(added_by(ice, 0, level), 150e3, 0, -150e3 * (level - 0.4));
}

TEST(ReservoirLoads, ALoadCaseTakesTheIceAway) {
  EXPECT_FALSE(
      read_text(dam(0, "[water]\nupstream_level_m = 12\n[ice]\nthrust_n_per_m = 0\nthickness_m = 0.5\n"), "s.toml")
          .scene.water.ice);
}

TEST(ReservoirLoads, IceThatLiesOnNoFaceIsWarnedOfWithWhatItLoses) {
  const auto warned = [](double level, const char* thickness) {
    const std::string ice = fmt::format("[ice]\nthrust_n_per_m = 150e3\nthickness_m = {}\n", thickness);
    return testing::PrintToString(
        read_text(dam(0, fmt::format("[water]\nupstream_level_m = {}\n", level) + ice), "s.toml").scene.warnings);
  };
  EXPECT_THAT(warned(10, "0.5"), testing::Not(HasSubstr("[ice]")));
  EXPECT_THAT(warned(10, "50"), testing::AllOf(HasSubstr("thickness_m in [ice] is 50 m, which is unusual"),
                                               HasSubstr("[ice] loses 80 % of its thrust")));
  EXPECT_THAT(warned(0.2, "0.5"), HasSubstr("[ice] loses 60 % of its thrust"));
}

TEST(ReservoirLoads, IceOnAFaceThatLeansIsWarnedOfWithWhatItHolds) {
  const auto warned = [](double foot_x) {
    const std::string ice = "[water]\nupstream_level_m = 12\n[ice]\nthrust_n_per_m = 150e3\nthickness_m = 0.5\n";
    return testing::PrintToString(read_text(dam(foot_x, ice), "s.toml").scene.warnings);
  };
  EXPECT_THAT(warned(-4), testing::AllOf(HasSubstr("20 % of its thrust presses down"),
                                         HasSubstr("state its thrust as a [[point_load]] on the block")));
  EXPECT_THAT(warned(-0.5), testing::Not(HasSubstr("[ice]")));
}

TEST(ReservoirLoads, TheNappePressesOnTheCrest) {
  const auto nappe = [](const char* law) {
    return added_by("", 0, 23, fmt::format("may_overtop = true\ncrest_pressure = '{}'\n", law));
  };
  const double head = 3 * 9810;
  expect_wrench(nappe("full"), 0, -4 * head, -4 * head * 2);
  expect_wrench(nappe("triangular"), 0, -2 * head, -2 * head * 4.0 / 3);
  expect_wrench(nappe("none"), 0, 0, 0);
}

TEST(ReservoirLoads, SiltPressesDownstreamAndDownWhereAFaceLooksUp) {
  const std::string silt = "[silt]\nlevel_m = 6\nsubmerged_density_kg_per_m3 = 900\npressure_coefficient = 0.4\n";
  const double vertical = 900 * 9.81 * 6;
  const auto on_dam = [&](double foot_x) {
    const auto scene = read_text(dam(foot_x, silt), "s.toml").scene;
    statics::Wrench w = statics::stated_loads_of(scene, 0)[1];
    w[2] += geometry::cross(statics::centroids_of(scene)[1], w.head<2>());
    return w;
  };
  expect_wrench(on_dam(0), 0.4 * vertical * 3, 0, -0.4 * vertical * 3 * 2);
  const double width = 6 * 4.0 / 20;  // that the silt stands over
  const statics::Wrench leaning = on_dam(-4);
  EXPECT_NEAR(leaning[0] / (0.4 * vertical * 3), 1, 1e-9);
  EXPECT_NEAR(leaning[1] / (-vertical * width / 2), 1, 1e-9);
}

/// A slab of 10 m before a wall: the silt's weight on it, and nothing on its end, where the ground goes on.
TEST(ReservoirLoads, SiltWeighsOnAFloorThatCanMove) {
  const auto scene = read_text(R"(analysis = { duration_s = 1 }
water = { upstream_level_m = 4 }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }
joint = { friction_angle_deg = 45 }
silt = { level_m = 3, submerged_density_kg_per_m3 = 1000, pressure_coefficient = 0.4 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-10, -5], [12, -5], [12, -2], [-10, -2]]
[[block]]
name = "slab"
material = "m"
vertices_m = [[-10, -2], [4, -2], [4, 0], [-10, 0]]
[[block]]
name = "wall"
material = "m"
vertices_m = [[0, 0], [3, 0], [1, 5], [0, 5]]
)",
                               "s.toml")
                         .scene;
  const auto loads = statics::stated_loads_of(scene, 0);
  EXPECT_NEAR(loads[1][0], 0, 1e-6);
  EXPECT_NEAR(loads[1][1] / -294300, 1, 1e-9);
  EXPECT_NEAR(loads[2][0] / (0.4 * 9810 * 9 / 2), 1, 1e-9);
  EXPECT_NEAR(loads[2][1], 0, 1e-6);
}

TEST(ReservoirLoads, AreRefusedWhereTheyCannotAct) {
  const auto refusal = [](const std::string& table) { return testing::PrintToString(errors(dam(0, table))); };
  EXPECT_THAT(refusal("[ice]\nthrust_n_per_m = 1e5\nthickness_m = 0.5\n"), HasSubstr("[ice] without a reservoir"));
  EXPECT_THAT(refusal("[ice]\nthrust_n_per_m = -1\nthickness_m = 0.5\n"), HasSubstr("a number of at least 0"));
  EXPECT_THAT(refusal("[silt]\nlevel_m = -1\nsubmerged_density_kg_per_m3 = 900\npressure_coefficient = 0.4\n"),
              HasSubstr("s.toml:17: error: level_m in [silt] is -1 m, below every upstream face"));
  EXPECT_THAT(refusal("[earthquake]\nhorizontal_coefficient = 9.81\n"), HasSubstr("a share of gravity"));
}

}  // namespace
}  // namespace blockweir::reservoir_loads_test
