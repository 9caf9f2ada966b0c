// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// The state at time 0 of scenes whose coordinates are rounded, of soft ones, and of what finds none.
#include <gtest/gtest.h>

#include "bridge/scene/read/check.hpp"
#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::start_test {
namespace {

/// Rows of bricks in a running bond, `across` in a row, all corners off by up to `off` of the whole structure's size.
scene::Scene rounded_wall(test::Random& random, double size_m, int rows, int across, double off) {
  auto scene = empty_scene();
  scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 35;
  const double unit = size_m / std::max(rows, across + 1);
  const auto rounded = [&](double x, double y) {
    const double by = off * size_m;
    return Point(x * unit + random.between(-by, by), y * unit + random.between(-by, by));
  };
  add(scene, {{-unit, -unit}, {(across + 2) * unit, -unit}, {(across + 2) * unit, 0}, {-unit, 0}}, true);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < across; ++i) {
      const double x = i + (row % 2) * 0.3;
      add(scene, {rounded(x, row), rounded(x + 1, row), rounded(x + 1, row + 1), rounded(x, row + 1)});
    }
  }
  return scene;
}

double weight_of(const Solid& solid) {
  double weight = 0;
  for (const Block& block : solid.blocks()) weight += block.fixed ? 0 : block.mass_per_m() * 9.81;
  return weight;
}

double reaction_on(int block, const Solid& solid) {
  double sum = 0;
  for (const ContactPoint& c : solid.contacts()) {
    const bool ground_is_edge = c.edge_block == block;
    if (c.state == ContactState::open || !(ground_is_edge || c.vertex_block == block)) continue;
    sum += c.force.x();
  }
  return sum;
}

TEST(Start, StructuresWithRoundedCoordinatesStandAtAnySize) {
  int checked = 0;
  for (int seed = 1; checked < test::campaign(30); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    const double size = random.over_decades(3e-3, 3e3);
    const int across = random.integer(1, 3);
    const int rows = random.integer(1, 8);
    // Corners of both blocks are off: a brick's tolerance is that of its own size.
    const double off = random.over_decades(1e-9, 1e-6) / std::max(rows, across + 1);
    auto scene = rounded_wall(random, size, rows, across, off);
    scene::Problems problems("scene.toml");
    check_overlaps(scene, problems);
    if (problems.count() > 0) continue;
    ++checked;
    Solid solid(scene);
    ASSERT_NO_THROW(solid.settle({})) << "seed " << seed << ", size " << size << ", " << rows << " x " << across;
    run(solid, 0.3);
    EXPECT_NEAR(reaction_on(0, solid) / weight_of(solid), 1, 1e-6) << "seed " << seed << ", size " << size;
    const double shortening = 2500 * 9.81 * size * size / 50e9;  // at most, by its own weight
    EXPECT_LT(solid.largest_displacement_m(), 1e-5 * size + 3 * shortening) << "seed " << seed << ", size " << size;
    for (const BlockState& state : solid.states()) {
      EXPECT_LT(state.velocity.head<2>().norm(), 1e-9 * size) << "seed " << seed << ", size " << size;
    }
  }
}

/// A column that strains freely: rho g h/(2 E) at its middle.
TEST(Start, ASoftColumnSettlesToItsStrain) {
  for (int seed = 1; seed <= test::campaign(20); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    auto scene = empty_scene();
    const double height = random.over_decades(0.1, 100);
    const double width = height * random.between(0.3, 1.5);
    const double strain = random.over_decades(1e-4, 0.15);
    scene.materials[0].poissons_ratio = 0;
    scene.materials[0].youngs_modulus_pa = 2500 * 9.81 * height / (2 * strain);
    add(scene, {{-9 * width, -1}, {9 * width, -1}, {9 * width, 0}, {-9 * width, 0}}, true);
    add(scene, {{0, 0}, {width, 0}, {width, height}, {0, height}});
    Solid solid(scene);
    ASSERT_NO_THROW(solid.settle({})) << "seed " << seed << ", strain " << strain;
    EXPECT_NEAR(solid.states()[1].displacement[4] / -strain, 1, 1e-6) << "seed " << seed;
    EXPECT_NEAR(reaction_on(0, solid) / weight_of(solid), 1, 1e-8) << "seed " << seed;
  }
}

std::string what_settling_says(const scene::Scene& scene) {
  try {
    Solid solid(scene);
    solid.settle({});
  } catch (const SolveError& error) {
    return error.what();
  }
  return "it settled";
}

TEST(Start, WhatIsTooSoftIsNamedWithItsStrain) {
  auto scene = empty_scene();
  scene.materials[0].youngs_modulus_pa = 25;
  add(scene, {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, true);
  add(scene, {{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  scene.blocks[1].line = 12;
  const std::string text = what_settling_says(scene);
  EXPECT_NE(text.find("block \"b1\" (line 12) is too soft"), std::string::npos) << text;
  EXPECT_NE(text.find("modulus = 981"), std::string::npos) << text;
  EXPECT_NE(text.find("youngs_modulus_pa = 25 of material \"concrete\" in Pa"), std::string::npos) << text;
}

TEST(Start, AStartThatFailsNamesWhatMovesAndWhatDoesNotFit) {
  auto scene = empty_scene();
  scene.contact.max_iterations = 1;
  add(scene, {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, true);
  add(scene, {{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  const std::string text = what_settling_says(scene);
  EXPECT_NE(text.find("no equilibrium under the first loads was found with all joints held"), std::string::npos)
      << text;
  EXPECT_NE(text.find("block \"b1\" moves most, by"), std::string::npos) << text;
  EXPECT_NE(text.find("blocks \"b1\" and \"b0\" fit least, at ("), std::string::npos) << text;
  EXPECT_NE(text.find("a larger [contact] max_iterations than 1 may help"), std::string::npos) << text;
  EXPECT_EQ(text.find("unstressed"), std::string::npos) << text;
}

/// Voussoirs between a fixed abutment and one that strains on two supports: gaps hovered about round-off.
TEST(Start, AnArchSettlesWhateverItsLastDigits) {
  constexpr double radius_m = 1.5;
  constexpr double size_m = 0.6;  // of the abutments
  for (int seed = 60; seed < 60 + test::campaign(30); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    auto scene = empty_scene();
    scene.materials[0] = {"concrete", 20e9, 0.2, random.between(1800, 2600)};
    const int voussoirs = random.integer(20, 40);
    const double inner_m = radius_m * random.between(0.65, 0.9);
    const double rise = random.between(0.26, 0.79);  // of the springing joint [rad]
    const auto at = [&](double from_centre_m, int joint) {
      const double angle = (M_PI / 2 - rise) * (1 - 2.0 * joint / voussoirs);
      return Point(from_centre_m * std::sin(angle), from_centre_m * std::cos(angle));
    };
    for (int k = 0; k < voussoirs; ++k) {
      add(scene, {at(inner_m, k), at(radius_m, k), at(radius_m, k + 1), at(inner_m, k + 1)});
    }
    const Point in = at(inner_m, 0);
    const Point out = at(radius_m, 0);
    const double foot_m = in.y() - size_m;
    const double far_m = out.x() + size_m;
    add(scene, {in, {in.x(), foot_m}, {far_m, foot_m}, {far_m, out.y()}, out});
    const Point in_left = at(inner_m, voussoirs);
    const Point out_left = at(radius_m, voussoirs);
    add(scene, {out_left, {-far_m, out.y()}, {-far_m, foot_m}, {in_left.x(), foot_m}, in_left}, true);
    for (const double x_m : {in.x(), far_m}) {
      scene.supports.push_back({.block = voussoirs,
                                .point_m = {x_m, foot_m},
                                .displacement_x_m = scene::TimeTable::constant(0),
                                .displacement_y_m = scene::TimeTable::constant(0)});
    }
    EXPECT_EQ(what_settling_says(scene), "it settled") << seed;
  }
}

/// A beam that is held at one point swings: at rest it would never be, and without stress it may set out.
TEST(Start, AStartThatNothingHoldsIsToldWhatWould) {
  for (const auto kind : {scene::AnalysisKind::dynamic, scene::AnalysisKind::at_rest}) {
    auto scene = empty_scene();
    scene.analysis.kind = kind;
    add(scene, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
    scene.supports.push_back({.block = 0,
                              .point_m = {0, 0},
                              .displacement_x_m = scene::TimeTable::constant(0),
                              .displacement_y_m = scene::TimeTable::constant(0)});
    const std::string text = what_settling_says(scene);
    EXPECT_NE(text.find("Give it a support, a bolt or a face to stand on"), std::string::npos) << text;
    EXPECT_EQ(text.find("start = \"unstressed\" if it is meant to move") != std::string::npos,
              kind == scene::AnalysisKind::dynamic)
        << text;
  }
}

/// A soft block that a push of 1.2 times its friction moves from the start.
TEST(Start, WhatMovesFromTheStartBeginsWhereTheSceneHasIt) {
  for (const bool rigid : {true, false}) {
    auto scene = empty_scene();
    scene.materials[0].youngs_modulus_pa = 1e8;
    scene.default_joint.friction_angle_deg = scene.default_joint.residual_friction_angle_deg = 20;
    add(scene, {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}}, true);
    add(scene, {{0, 0}, {3, 0}, {3, 2}, {0, 2}});
    scene.blocks[1].rigid = rigid;
    scene::BodyLoad push;
    push.blocks = {1};
    push.value = {scene::TimeTable::constant(1.2 * 9.81 * std::tan(std::acos(-1.0) / 9)),
                  scene::TimeTable::constant(0)};
    scene.body_loads.push_back(push);
    Solid solid(scene);
    solid.settle({});
    const double strained = 2500 * 9.81 * 2 / 1e8 * 3;  // m, of its own weight over its length
    EXPECT_LT(solid.largest_displacement_m(), rigid ? 1e-12 : strained) << rigid;
    EXPECT_TRUE(solid.states()[1].velocity.isZero(0));
  }
}

}  // namespace
}  // namespace blockweir::solid::start_test
