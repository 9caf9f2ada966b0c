// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_block
// A crack's end has the pressure of the water that wets it, on whichever side of the structure that stands.
#include "fluid/hydrostatic/crack_pools.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/still_water.hpp"

namespace blockweir::hydrostatic::crack_pools_test {
namespace {

using tests::load_at_rest;
using tests::scene_of;

constexpr double weight_n_per_m3 = 9810;

/// Of the water in cracks on a block, along the edge that begins at its vertex 0.
double crack_force(const scene::Scene& scene, const wire::Load& load, std::uint32_t block) {
  const double length = (scene.blocks[block].vertices[1] - scene.blocks[block].vertices[0]).norm();
  double force = 0;
  for (std::size_t i = load.cracks_from; i < load.block.size(); ++i) {
    if (load.block[i] != block || load.edge[i] != 0) continue;
    force += length * (load.s_to[i] - load.s_from[i]) * (load.pressure_from_pa[i] + load.pressure_to_pa[i]) / 2;
  }
  return force;
}

/// A dam of 10 m at 0 <= x <= 8 m on level ground at y = 0, and a slab; uplift by this law.
scene::Scene dam_and_slab(std::vector<Point> slab, double upstream_m, double downstream_m, scene::Uplift law) {
  scene::Scene scene =
      scene_of({{{-60, -5}, {60, -5}, {60, 0}, {-60, 0}}, {{0, 0}, {8, 0}, {3, 10}, {0, 10}}, slab}, upstream_m);
  scene.blocks[0].fixed = true;
  if (downstream_m > 0) scene.water.downstream_level_m = scene::TimeTable::constant(downstream_m);
  scene.default_joint.uplift = law;
  scene.analysis.gravity_m_per_s2 = 9.81;
  return scene;
}

TEST(CrackPools, SubmergedSlabsOnBothSidesHaveTheUpliftOfTheirOwnWater) {
  std::mt19937_64 random(20261125);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  constexpr int each_side = 40;
  for (int i = 0; i < 2 * each_side; ++i) {
    const bool upstream = i % 2 == 0;
    const double downstream_m = between(1.5, 4);
    const double upstream_m = between(5, 9.5);
    const double own_m = upstream ? upstream_m : downstream_m;
    const double length = between(0.5, 8);
    const double height = between(0.3, 0.9) * own_m;
    const double from = upstream ? between(-40, -12) : between(12, 40);
    // Faces lean out over the water or back over the slab, by up to 45 degrees, and do not meet.
    const auto lean = [&] {
      return std::clamp(height * std::tan(between(-0.25, 0.25) * std::numbers::pi), -3., length / 3);
    };
    const std::vector<Point> slab = {
        {from, 0}, {from + length, 0}, {from + length - lean(), height}, {from + lean(), height}};
    const auto law = i % 3 == 0 ? scene::Uplift::full : i % 3 == 1 ? scene::Uplift::triangular : scene::Uplift::cracked;
    const scene::Scene scene = dam_and_slab(slab, upstream_m, downstream_m, law);
    const wire::Load load = load_at_rest(scene);
    const double by_hand = weight_n_per_m3 * own_m * length;
    EXPECT_NEAR(crack_force(scene, load, 2) / by_hand, 1, 1e-12) << "slab " << i;
    const double of_dam = law == scene::Uplift::full ? upstream_m : (upstream_m + downstream_m) / 2;
    if (law != scene::Uplift::cracked) {
      EXPECT_DOUBLE_EQ(crack_force(scene, load, 1), weight_n_per_m3 * of_dam * 8) << "dam " << i;
    }
  }
}

/// Open water comes to within two widths of a crack that carries it, on both sides: each end keeps that of its side.
TEST(CrackPools, AWallThinnerThanAnOpenCrackHasBothPools) {
  for (const double thick_m : {0.02, 0.08, 0.15}) {
    for (const double downstream_m : {0.0, 1.0}) {
      scene::Scene scene =
          scene_of({{{-9, -5}, {9, -5}, {9, 0}, {-9, 0}}, {{0, 0}, {thick_m, 0}, {thick_m, 3}, {0, 3}}}, 2);
      scene.blocks[0].fixed = true;
      if (downstream_m > 0) scene.water.downstream_level_m = scene::TimeTable::constant(downstream_m);
      scene.default_joint.uplift = scene::Uplift::triangular;
      EXPECT_NEAR(crack_force(scene, load_at_rest(scene), 1),
                  scene::unit_weight_of_water(scene) * (2 + downstream_m) / 2 * thick_m, 1e-9)
          << thick_m;
    }
  }
}

/// The bed joint of the downstream column begins within the dam, at the upright joint 0.1 m from the reservoir.
TEST(CrackPools, AnEndWithinTheStructureHasThePressureOfItsSide) {
  scene::Scene scene = scene_of({{{-9, -5}, {9, -5}, {9, 0}, {-9, 0}},
                                 {{0.1, 0}, {2, 0}, {2, 4}, {0.1, 4}},
                                 {{0, 0}, {0.1, 0}, {0.1, 4}, {0, 4}}},
                                3);
  scene.blocks[0].fixed = true;
  scene.water.downstream_level_m = scene::TimeTable::constant(1);
  scene.joints.push_back({.name = "face", .between = {0, 2}, .law = {.uplift = scene::Uplift::triangular}});
  const double unit = scene::unit_weight_of_water(scene);
  EXPECT_NEAR(crack_force(scene, load_at_rest(scene), 2), unit * (3 + 1) / 2.0 * 0.1, 1e-9);
}

/// A slab in the tailwater that leaves its place has that pool's pressure as long as the pool is beside it.
TEST(CrackPools, TheWaterOfASlabThatMovesIsThatWhichIsBesideItNow) {
  const scene::Scene scene = dam_and_slab({{20, 0}, {24, 0}, {24, 1}, {20, 1}}, 8, 2, scene::Uplift::triangular);
  HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(scene.blocks.size());
  motion.velocity.own().resize(scene.blocks.size());
  for (const double slid_m : {0.0, 0.03, 0.1, 1.0}) {
    motion.displacement.own()[2][0] = slid_m;
    wire::Load load;
    model.advance(motion, slid_m, load);
    // What of the crack the slab has left is open water, and so is what of the slab has gone beyond the crack.
    for (std::size_t i = load.cracks_from; i < load.block.size(); ++i) {
      if (load.block[i] != 2) continue;
      EXPECT_DOUBLE_EQ(load.pressure_from_pa[i], 2 * weight_n_per_m3) << slid_m;
      EXPECT_DOUBLE_EQ(load.pressure_to_pa[i], 2 * weight_n_per_m3) << slid_m;
    }
  }
}

}  // namespace
}  // namespace blockweir::hydrostatic::crack_pools_test
