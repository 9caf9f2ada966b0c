// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Keys of the water that flows through joints, and what is wrong with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "bridge/scene/read/read.hpp"

namespace blockweir::scene::scene_joint_flow_test {
namespace {

using ::testing::HasSubstr;

const std::string dam = R"(analysis = { duration_s = 1, step_s = 0.01 }
[material.concrete]
youngs_modulus_pa = 30e9
poissons_ratio = 0.2
density_kg_per_m3 = 2400
[joint]
uplift = "flow"
hydraulic_aperture_m = 1e-4
[[block]]
name = "rock"
material = "concrete"
fixed = true
vertices_m = [[-10, -5], [20, -5], [20, 0], [-10, 0]]
[[block]]
name = "dam"
material = "concrete"
vertices_m = [[0, 0], [8, 0], [3, 10], [0, 10]]
[water]
upstream_level_m = 8
)";

Scene read_dam(const std::string& more) {
  return read_text(dam + more, "dam.toml").scene;
}

std::string fault(const std::string& more, const std::vector<std::string>& set = {}) {
  try {
    read_text(dam + more, "dam.toml", set);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneJointFlow, KeysAreRead) {
  const Scene scene = read_dam(R"(
[joint_flow]
kind = "transient"
viscosity_pa_s = 1e-3
bulk_modulus_pa = 2.2e9
panels_per_joint = 4
[[drain]]
name = "gallery"
from_m = [2, -2]
to_m = [2, 1]
head_m = 1
efficiency = 0.5
[[grout]]
name = "curtain"
outline_m = [[0, -3], [1, -3], [1, 1], [0, 1]]
aperture_factor = 0.1
)");
  EXPECT_EQ(scene.default_joint.uplift, Uplift::flow);
  EXPECT_EQ(scene.default_joint.hydraulic_aperture_m, 1e-4);
  EXPECT_EQ(scene.joint_flow.kind, FlowKind::transient);
  EXPECT_EQ(scene.joint_flow.bulk_modulus_pa, 2.2e9);
  EXPECT_EQ(scene.joint_flow.panels_per_joint, 4);
  ASSERT_EQ(scene.joint_flow.drains.size(), 1);
  EXPECT_EQ(scene.joint_flow.drains[0].head_m, 1.0);
  ASSERT_EQ(scene.joint_flow.grouts.size(), 1);
  EXPECT_EQ(scene.joint_flow.grouts[0].aperture_factor, 0.1);
  EXPECT_TRUE(flows_in_joints(scene));
}

TEST(SceneJointFlow, ADrainInNoJointIsRefused) {
  EXPECT_THAT(fault("[[drain]]\nname = \"d\"\nfrom_m = [2, -3]\nto_m = [2, -1]\n"),
              HasSubstr("drain \"d\" crosses no joint with flow"));
}

TEST(SceneJointFlow, GroutAroundNoJointIsRefused) {
  EXPECT_THAT(
      fault("[[grout]]\nname = \"g\"\noutline_m = [[0, -3], [1, -3], [1, -2], [0, -2]]\naperture_factor = 0.1\n"),
      HasSubstr("grout \"g\" holds no joint with flow"));
}

TEST(SceneJointFlow, KeysWithoutFlowAreRefused) {
  const std::vector<std::string> full = {"joint={friction_angle_deg=30}"};
  EXPECT_THAT(fault("[joint_flow]\nviscosity_pa_s = 1e-3\n", full), HasSubstr("[joint_flow] has no effect"));
  EXPECT_THAT(fault("[[drain]]\nname = \"d\"\nfrom_m = [2, -3]\nto_m = [2, 1]\n", full), HasSubstr("has no effect"));
}

TEST(SceneJointFlow, AMeshAtAJointWithFlowIsRefused) {
  EXPECT_THAT(fault("", {"block.dam.mesh_size_m=2"}), HasSubstr("block \"dam\" has a mesh, and water flows through"));
}

TEST(SceneJointFlow, AFluidOfTheUsersIsRefused) {
  EXPECT_THAT(fault("[fluid]\nmodel = \"external\"\n[fluid.external]\ncommand = \"./own\"\n"),
              HasSubstr("uplift = \"flow\" with model = \"external\""));
}

TEST(SceneJointFlow, DrainsThatTakeNothingAreWarnedOf) {
  const std::string drain = "[[drain]]\nname = \"d\"\nfrom_m = [2, -3]\nto_m = [2, 1]\n";
  const auto warnings = [&](const std::string& more) { return read_dam(drain + more).warnings; };
  EXPECT_THAT(warnings("head_m = 8\n"), testing::Contains(HasSubstr("no level is above 8 m: it takes nothing")));
  EXPECT_THAT(warnings("efficiency = 0\n"), testing::Contains(HasSubstr("an efficiency of 0: it takes nothing")));
  EXPECT_THAT(warnings("head_m = 7.9\n"), testing::Not(testing::Contains(HasSubstr("takes nothing"))));
}

TEST(SceneJointFlow, AperturesBeyondTheirBoundsAreRefused) {
  EXPECT_THAT(fault("", {"joint.hydraulic_aperture_m=0.5"}), HasSubstr("hydraulic_aperture_m of [joint] is 0.5 m"));
  for (const char* width : {"0", "-1"}) {
    EXPECT_THAT(fault("", {"joint.hydraulic_aperture_m=" + std::string(width)}),
                HasSubstr("expected a number above 0"));
    EXPECT_THAT(fault("", {"joint.least_aperture_m=" + std::string(width)}), HasSubstr("expected a number above 0"));
  }
  EXPECT_THAT(fault("", {"joint.least_aperture_m=1e-3"}), HasSubstr("least_aperture_m of [joint] is 0.001 m"));
  EXPECT_THAT(fault("", {"joint.largest_aperture_m=0.5"}), HasSubstr("largest_aperture_m of [joint] is 0.5 m"));
  EXPECT_THAT(fault("", {"joint.aperture_stiffness_pa_per_m=0"}), HasSubstr("a number above 0"));
  EXPECT_THAT(fault("", {"joint_flow.panels_per_joint=0"}), HasSubstr("panels_per_joint"));
}

TEST(SceneJointFlow, TwoDrainsOfOneNameAreRefused) {
  const std::string one = "[[drain]]\nname = \"d\"\nfrom_m = [2, -3]\nto_m = [2, 1]\n";
  EXPECT_THAT(fault(one + one), HasSubstr("second"));
}

}  // namespace
}  // namespace blockweir::scene::scene_joint_flow_test
