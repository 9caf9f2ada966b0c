// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_block
// What is told of water in joints: each joint's uplift beside that of guideline laws, tables, and how water splits at a
// drain.
#include "fluid/joints/uplift_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "fluid/joints/flow_output.hpp"
#include "fluid/joints/flow_tables.hpp"
#include "tests/joint_water.hpp"

namespace blockweir::joints::joint_uplift_test {
namespace {

using namespace tests;

/// No constant: that of the ground, of another file, may be made after it.
scene::Scene dam() {
  return tests::flowing({ground, {{0, 0}, {8, 0}, {3, 10}, {0, 10}}}, 9);
}

TEST(JointUplift, AParallelJointHasTheUpliftOfTheLawThatItFollows) {
  scene::Scene scene = dam();
  const double mouth = 9 * weight_n_per_m3;
  for (const bool drained : {false, true}) {
    if (drained) scene.joint_flow.drains = {{"curtain", {2, -1}, {2, 1}, 0.0, 0.7}};
    hydrostatic::HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const std::vector<JointUplift> joints = joint_uplifts(scene, model.flow_in_joints());
    ASSERT_EQ(joints.size(), 1);
    const JointUplift& j = joints[0];
    EXPECT_NEAR(j.length_m, 8, 1e-12);
    EXPECT_NEAR(j.triangular_n_per_m, mouth * 4, 1e-9 * mouth);
    EXPECT_NEAR(j.full_n_per_m, mouth * 8, 1e-9 * mouth);
    ASSERT_EQ(j.drained_n_per_m.has_value(), drained);
    EXPECT_NEAR(j.uplift_n_per_m, drained ? *j.drained_n_per_m : j.triangular_n_per_m, 1e-9 * mouth);
    const double at_drain = 0.3 * mouth * 6 / 8;
    const double fall = drained ? (mouth - at_drain) / 2 : mouth / 8;
    const double q = std::pow(aperture, 3) / (12 * scene.joint_flow.viscosity_pa_s) * fall;
    EXPECT_NEAR(j.flow_m2_per_s / q, 1, 1e-9);
    EXPECT_NEAR(j.reynolds / (q * 1000 / scene.joint_flow.viscosity_pa_s), 1, 1e-9);
  }
}

/// A joint that dips from the pool into air, with a drain half way down. What gravity draws on is served first.
TEST(JointUplift, ADrainTakesWhatTheJointBelowItDoesNot) {
  scene::Scene scene = tests::flowing(
      {{{-20, -10}, {30, -10}, {30, -4}, {8, -4}, {0, 0}, {-20, 0}}, {{0, 0}, {8, -4}, {8, 6}, {0, 6}}}, 1);
  scene.joint_flow.drains = {{"gallery", {4, -3}, {4, -1}, {}, 1.0}};
  const double unit = std::pow(aperture, 3) / (12 * scene.joint_flow.viscosity_pa_s) * weight_n_per_m3 /
                      std::hypot(4.0, 2.0);  // flow per metre of head over a half
  for (const double narrowed : {1.0, 0.5}) {
    if (narrowed < 1) scene.joint_flow.grouts = {{"above", {{-1, -3}, {4, -3}, {4, 1}, {-1, 1}}, narrowed}};
    hydrostatic::HydrostaticModel model(scene);
    wire::Load load;
    model.advance(at_rest(scene), 0, load);
    const FlowBalance balance = model.flow_in_joints().balance();
    const double comes = std::pow(narrowed, 3) * 3 * unit;
    EXPECT_NEAR(balance.from_open_water / unit, comes / unit, 1e-9) << narrowed;
    EXPECT_NEAR(balance.to_drain[0] / unit, std::max(0.0, comes / unit - 2), 1e-9) << narrowed;
    EXPECT_NEAR(balance.to_air / unit, std::min(2.0, comes / unit), 1e-9) << narrowed;
  }
}

TEST(JointUplift, OfAJointThatHasOpenedAllAlongThereIsNone) {
  for (const scene::FlowKind kind : {scene::FlowKind::steady, scene::FlowKind::transient}) {
    scene::Scene scene = dam();
    scene.joint_flow.kind = kind;
    hydrostatic::HydrostaticModel model(scene);
    wire::Motion motion = at_rest(scene);
    wire::Load load;
    model.advance(motion, 0, load);
    motion.displacement.own()[1] = {0, 1, 0, 0, 0, 0};
    model.advance(motion, 0.1, load);
    EXPECT_TRUE(joint_uplifts(scene, model.flow_in_joints()).empty());
    EXPECT_TRUE(model.flow_in_joints().warnings().empty());
  }
}

TEST(JointUplift, TheLastRowOfTheFlowIsThatOfTheRunsEnd) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "blockweir_joint_uplift_test";
  std::filesystem::create_directories(folder);
  scene::Scene scene = dam();
  scene.output.history_every_s = 1;
  hydrostatic::HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  {
    FlowTables tables(scene, folder);
    for (const double time_s : {0.0, 0.4, 1.0, 1.3}) tables.record(time_s, model.flow_in_joints());
  }
  std::ifstream file(folder / "flow.csv");
  std::vector<std::string> times;
  for (std::string line; std::getline(file, line);) times.push_back(line.substr(0, line.find(',')));
  EXPECT_THAT(times, testing::ElementsAre("time_s", "0", "1", "1.3"));
  std::filesystem::remove_all(folder);
}

/// Frames are due at 0 and 10 s; the water comes to rest at 1.3 s, and nothing is recorded after.
TEST(JointUplift, AllTablesEndWithTheStateThatFlowCsvEndsWith) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "blockweir_joint_uplift_end_test";
  std::filesystem::create_directories(folder);
  scene::Scene scene = dam();
  scene.output.history_every_s = 1;
  scene.output.frame_every_s = 10;
  hydrostatic::HydrostaticModel model(scene);
  wire::Load load;
  model.advance(at_rest(scene), 0, load);
  {
    FlowOutput output(scene, folder);
    for (const double time_s : {0.0, 1.0, 1.3}) output.record(time_s, model.flow_in_joints());
  }
  const auto last_time = [&](const char* name) {
    std::ifstream file(folder / name);
    std::string last;
    for (std::string line; std::getline(file, line);) last = line;
    return last.substr(0, last.find(','));
  };
  EXPECT_EQ(last_time("flow.csv"), "1.3");
  EXPECT_EQ(last_time("joint_water.csv"), "1.3");
  EXPECT_EQ(last_time("joint_uplift.csv"), "1.3");
  std::ostringstream frames;
  frames << std::ifstream(folder / "flow.pvd").rdbuf();
  EXPECT_THAT(frames.str(), testing::HasSubstr("timestep=\"1.3\""));
  EXPECT_THAT(frames.str(), testing::Not(testing::HasSubstr("timestep=\"1\"")));
  std::filesystem::remove_all(folder);
}

/// 2e-4 m2 beside the 1e-3 m2 of the joints, at windows of 0.02 s: twice the share that is little.
TEST(TransientGuard, NamesTheWindowThatMakesItSmall) {
  TransientGuard guard;
  const Filling before{.pressure_pa = {0, 1e5}, .saturation = {1, 1}, .flow = {}, .to_air = {}};
  const Filling after{.pressure_pa = {0, 2e5}, .saturation = {1, 1}, .flow = {}, .to_air = {}};
  const std::vector<double> stored_before = {0, 1e-4};
  const std::vector<double> stored = {0, 2e-4};
  guard.add({before, after, stored_before, stored}, {2e-9, 2e-9}, 9e-4, 0.02);
  EXPECT_THAT(guard.warning(),
              testing::HasSubstr("took in 20 % as much water as the joints did, at windows of 0.02 s"));
  EXPECT_THAT(guard.warning(), testing::HasSubstr("set window_s of [coupling] to 0.01 s or less"));
  guard.add({before, before, stored, stored}, {2e-9, 2e-9}, 9e-3, 0.02);
  EXPECT_EQ(guard.warning(), "");
}

}  // namespace
}  // namespace blockweir::joints::joint_uplift_test
