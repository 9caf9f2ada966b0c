// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_block
// What holds the water at the ends of joints and along them: pools, air, drains, grout, ground that goes on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "fluid/joints/flow_tables.hpp"
#include "tests/joint_water.hpp"

namespace blockweir::hydrostatic::joint_mouths_test {
namespace {

using namespace tests;

TEST(JointMouths, ADrainHoldsItsHeadAndTakesItsShare) {
  scene::Scene scene = flowing({ground, {{0, 0}, {8, 0}, {3, 10}, {0, 10}}}, 9);
  for (const double efficiency : {1.0, 0.6}) {
    scene.joint_flow.drains = {{"curtain", {2, -1}, {2, 1}, 0.0, efficiency}};
    HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const double mouth = 9 * weight_n_per_m3;
    const double at_drain = (1 - efficiency) * mouth * 6 / 8;
    EXPECT_NEAR(joint_water(scene, load, 1, 0).force, (mouth + at_drain) / 2 * 2 + at_drain / 2 * 6, 1e-10 * 8 * mouth);
    const double g = std::pow(aperture, 3) / (12 * scene.joint_flow.viscosity_pa_s);
    EXPECT_NEAR(model.flow_in_joints().balance().to_drain[0], g * ((mouth - at_drain) / 2 - at_drain / 6),
                1e-10 * g * mouth);
  }
}

TEST(JointMouths, ADrainGivesNoWater) {
  scene::Scene scene = flowing({ground, {{0, 0}, {8, 0}, {3, 10}, {0, 10}}}, 3);
  scene.joint_flow.drains = {{"gallery", {4, -1}, {4, 1}, 7.0, 1.0}};
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  EXPECT_EQ(model.flow_in_joints().balance().to_drain[0], 0);
  EXPECT_NEAR(joint_water(scene, load, 1, 0).force, 3 * weight_n_per_m3 * 8 / 2, 1e-9 * 3 * weight_n_per_m3 * 8);
}

TEST(JointMouths, GroutTakesTheHeadUpstreamOfIt) {
  scene::Scene scene = flowing({ground, {{0, 0}, {8, 0}, {3, 10}, {0, 10}}}, 9);
  scene.joint_flow.grouts = {{"curtain", {{1, -2}, {3, -2}, {3, 1}, {1, 1}}, 0.25}};
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  const double mouth = 9 * weight_n_per_m3;
  const double total = 1 + 2 * 64 + 5;
  const double p1 = mouth * (1 - 1 / total);
  const double p3 = mouth * 5 / total;
  EXPECT_NEAR(joint_water(scene, load, 1, 0).force, (mouth + p1) / 2 + (p1 + p3) + p3 / 2 * 5, 1e-9 * 8 * mouth);
}

TEST(JointMouths, TheModelsEndsInTheGroundLetNoWaterOut) {
  // Two beds of rock under a dam: the joint between them ends on the model's sides.
  const scene::Scene scene = flowing({{{-20, -10}, {30, -10}, {30, -5}, {-20, -5}},
                                      {{-20, -5}, {4, -5}, {4, 0}, {-20, 0}},
                                      {{4, -5}, {30, -5}, {30, 0}, {4, 0}},
                                      {{0, 0}, {8, 0}, {3, 10}, {0, 10}}},
                                     9);
  scene::Scene held = scene;
  for (std::size_t b : {1U, 2U}) held.blocks[b].fixed = true;
  HydrostaticModel model(held);
  wire::Load load;
  model.advance(at_rest(held), 0, load);
  // Nothing flows down there: the joint below has the head of the dam's base above its upright joint, the middle's.
  const auto& flow = model.flow_in_joints();
  for (std::size_t i = 0; i < flow.joints().places().size(); ++i) {
    if (flow.joints().places()[i].at.y() > -4.9) continue;
    EXPECT_NEAR(flow.filling().pressure_pa[i], (9 * 0.5 + 5) * weight_n_per_m3, 1) << i;
    EXPECT_EQ(flow.joints().network().nodes[i].kind, joints::NodeKind::inside);
  }
}

TEST(JointMouths, AStepBesideTheHeelIsNoJoint) {
  // A joint of the rock ends 24 mm upstream of the heel, and the rock before it stands 1.2 mm higher.
  scene::Scene scene = flowing({{{-30, -6}, {-0.024, -6}, {-0.024, 0.0012}, {-30, 1.5}},
                                {{-0.024, -6}, {20, -6}, {20, 0}, {-0.024, 0}},
                                {{0, 0}, {4, 0}, {4, 10}, {0, 10}}},
                               6);
  scene.blocks[1].fixed = true;
  scene.water.open_crack_width_m = 0.025;
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  EXPECT_NEAR(joint_water(scene, load, 2, 0).force, 6 * weight_n_per_m3 * 4 / 2, 1e-6 * 6 * weight_n_per_m3);
}

TEST(JointMouths, AMouthOnTheModelsSideLetsNoTailwaterIn) {
  for (const double depth : {0.05, 0.09, 0.15}) {
    scene::Scene scene = flowing({{{-20, -5}, {30, -5}, {30, -depth}, {-20, -depth}},
                                  {{-20, -depth}, {30, -depth}, {30, 0}, {-20, 0}},
                                  {{0, 0}, {8, 0}, {3, 10}, {0, 10}}},
                                 9);
    scene.blocks[1].fixed = true;
    scene.water.downstream_level_m = scene::TimeTable::constant(2);
    HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const double q = std::pow(aperture, 3) / (12 * scene.joint_flow.viscosity_pa_s) * weight_n_per_m3 * 7 / 8;
    EXPECT_NEAR(model.flow_in_joints().balance().from_open_water / q, 1, 1e-9) << depth;
  }
}

TEST(JointMouths, SteadyFlowStaysSteadyInTransientFlow) {
  // The lift joint seeps out at the top of a wide joint that begins there.
  scene::Scene scene = flowing(
      {ground, {{0, 0}, {4, 0}, {4, 5}, {0, 5}}, {{4, 0}, {9, 0}, {9, 5}, {4, 5}}, {{0, 5}, {4, 5}, {4, 10}, {0, 10}}},
      8);
  scene.joint_flow.kind = scene::FlowKind::transient;
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  const joints::FlowBalance before = model.flow_in_joints().balance();
  for (int i = 1; i <= 20; ++i) model.advance(at_rest(scene), 0.1 * i, load);
  const joints::FlowBalance after = model.flow_in_joints().balance();
  EXPECT_NEAR(after.from_open_water / before.from_open_water, 1, 1e-9);
  EXPECT_NEAR(after.to_air / before.to_air, 1, 1e-9);
  EXPECT_NEAR(after.stored / before.stored, 1, 1e-9);
}

TEST(JointMouths, ADrainTakesNoMoreThanComesBeyondWhatTheJointBelowCarries) {
  // A falling joint, drained halfway without a head: what its lower half carries at no pressure goes on.
  for (const double below : {1.5, 1.0, 0.5}) {
    scene::Scene scene =
        flowing({{{-20, -9}, {30, -9}, {30, -4}, {8, -4}, {0, 0}, {-20, 0}}, {{0, 0}, {8, -4}, {8, 8}, {0, 8}}}, 6);
    scene.joint_flow.drains = {{"drain", {4, -5}, {4, 0}, std::nullopt, 1.0}};
    scene.joint_flow.grouts = {{"below", {{4, -6}, {9, -6}, {9, 1}, {4, 1}}, below}};
    HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const double g = std::pow(aperture, 3) / (12 * scene.joint_flow.viscosity_pa_s);
    const double half = std::hypot(4, 2);
    const double comes = g * weight_n_per_m3 * (6 + 2) / half;
    const double goes_on = g * std::pow(below, 3) * weight_n_per_m3 * 2 / half;
    const joints::FlowBalance balance = model.flow_in_joints().balance();
    EXPECT_NEAR(balance.to_drain[0] / (comes - goes_on), 1, 1e-6) << below;
    EXPECT_NEAR(balance.to_air / goes_on, 1, 1e-6) << below;
  }
}

TEST(JointMouths, WaterThatFallsThroughAnUnevenGapHasNoSuction) {
  const scene::Scene scene =
      flowing({{{-20, -9}, {30, -9}, {30, -2}, {4, -2}, {0, 0}, {-20, 0}}, {{0, 0}, {4, -1.994}, {4, 8}, {0, 8}}}, 5);
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  for (std::size_t i = 0; i < load.block.size(); ++i) {
    EXPECT_GE(load.pressure_from_pa[i], 0);
    EXPECT_GE(load.pressure_to_pa[i], 0);
  }
  EXPECT_GT(joint_water(scene, load, 1, 0).force, 0);
}

TEST(JointMouths, AnUnevenGapHasSomeFiftyRowsInItsTable) {
  const scene::Scene scene =
      flowing({{{-20, -9}, {30, -9}, {30, -2}, {4, -2}, {0, 0}, {-20, 0}}, {{0, 0}, {4, -1.994}, {4, 8}, {0, 8}}}, 5);
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  const std::string folder = testing::TempDir() + "uneven-gap";
  std::filesystem::create_directories(folder);
  joints::FlowTables(scene, folder).record(0, model.flow_in_joints());
  std::ifstream table(folder + "/joint_water.csv");
  const auto rows = std::count(std::istreambuf_iterator<char>(table), {}, '\n') - 1;
  EXPECT_GE(rows, 50);
  EXPECT_LE(rows, 100);  // of 20 parts, each with its two ends
  std::filesystem::remove_all(folder);
}

TEST(JointMouths, AMouthInAHollowIsToldOf) {
  scene::Scene scene =
      flowing({{{-20, -5}, {30, -5}, {30, 2.5}, {4, 0}, {-20, 0}}, {{0, 0}, {4, 0}, {4, 10}, {0, 10}}}, 8);
  scene.water.downstream_level_m = scene::TimeTable::constant(2);
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  EXPECT_THAT(model.report().warnings,
              testing::Contains(testing::HasSubstr("ends in air at (4, 0) m, below the downstream")));
}

TEST(JointMouths, HowManyLieInAHollowIsToldOf) {
  // Two lift joints end in the hollow between the wall and the rising ground.
  scene::Scene scene = flowing({{{-20, -5}, {30, -5}, {30, 4.5}, {8, 4.5}, {4, 0}, {-20, 0}},
                                {{0, 0}, {4, 0}, {4, 1}, {0, 1}},
                                {{0, 1}, {4, 1}, {4, 2}, {0, 2}},
                                {{0, 2}, {4, 2}, {4, 10}, {0, 10}}},
                               8);
  scene.water.downstream_level_m = scene::TimeTable::constant(4);
  HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  EXPECT_THAT(model.report().warnings,
              testing::Contains(testing::HasSubstr("3 ends of joints with uplift = \"flow\" lie in air, the first")));
}

/// A joint from the pool to a gap behind the lower block, whose contacts with the rock have no flow. `roof`: as far as
/// the upper block reaches, to the rock at 10 m or less far.
scene::Scene with_a_gap_behind(double behind_m, double roof_m) {
  scene::Scene scene = flowing({{{-20, -5}, {20, -5}, {20, 12}, {10, 12}, {10, 0}, {-20, 0}},
                                {{0, 0}, {10 - behind_m, 0}, {10 - behind_m, 3}, {0, 3}},
                                {{0, 3}, {roof_m, 3}, {roof_m, 10}, {0, 10}}},
                               8);
  scene::Joint bed;
  bed.name = "bed";
  bed.between = {1, 2};
  bed.law = scene.default_joint;
  scene.joints.push_back(bed);
  scene.default_joint.uplift = scene::Uplift::none;
  scene.water.open_crack_width_m = 0.05;
  return scene;
}

TEST(JointMouths, AGapInsideIsAirOnlyWhereAWayLeadsOut) {
  const auto outflow_and_force = [](double behind_m, double roof_m) {
    const scene::Scene scene = with_a_gap_behind(behind_m, roof_m);
    HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const double full = 5 * weight_n_per_m3 * (10 - behind_m);
    return std::pair(model.flow_in_joints().balance().to_air, joint_water(scene, load, 2, 0).force / full);
  };
  for (const double closed_m : {0.03, 0.1, 0.5}) {
    const auto [outflow, force] = outflow_and_force(closed_m, 10);
    EXPECT_EQ(outflow, 0) << closed_m;
    EXPECT_NEAR(force, 1, 1e-9) << closed_m;
  }
  // A way up to the air that is narrower than open_crack_width_m leads nowhere, a wider one does.
  EXPECT_EQ(outflow_and_force(0.1, 9.97).first, 0);
  const auto [outflow, force] = outflow_and_force(0.1, 9.9);
  EXPECT_GT(outflow, 0);
  EXPECT_NEAR(force, 0.5, 1e-9);
}

}  // namespace
}  // namespace blockweir::hydrostatic::joint_mouths_test
