// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Every key of [joint] that needs another one says so where that is stated as nothing, for no other joint has it.
#include <fmt/format.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_idle_joint_keys_test {
namespace {

using namespace blockweir::scene;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

std::string scene_with(const std::string& joint, const std::string& more = "") {
  return "[analysis]\nduration_s = 1\n[water]\nupstream_level_m = 2\n[material.m]\nyoungs_modulus_pa = 1e10\n"
         "poissons_ratio = 0.2\ndensity_kg_per_m3 = 2300\n[[block]]\nname = 'g'\nmaterial = 'm'\nfixed = true\n"
         "vertices_m = [[-10, -3], [12, -3], [12, 0], [-10, 0]]\n[[block]]\nname = 'w'\nmaterial = 'm'\n"
         "vertices_m = [[0, 0], [2.5, 0], [1, 5], [0, 5]]\n[joint]\nfriction_angle_deg = 30\n" +
         joint + more;
}

const std::vector<std::pair<std::string, std::string>> needs{
    {"hydraulic_aperture_m = 1e-4", "uplift = 'triangular'"},
    {"least_aperture_m = 1e-5", "uplift = 'full'"},
    {"largest_aperture_m = 1e-3", "uplift = 'triangular'"},
    {"aperture_stiffness_pa_per_m = 1e9", "uplift = 'triangular'"},
    {"aperture_pressure_pa = 1e4", "uplift = 'full'"},
    {"keeps_cohesion = true", "cohesion_pa = 0"},
    {"bonded_length_m = 1", "tension_strength_pa = 0"},
    {"dilation_limit_m = 0.01", "dilation_angle_deg = 0"},
};

TEST(IdleKeysOfTheDefaultJoint, AreWarnedOfBesideALawThatDoesWithoutThem) {
  for (const auto& [key, law] : needs) {
    const std::string text = scene_with(law + "\n" + key + "\n");
    EXPECT_THAT(sample::errors(text), IsEmpty()) << text;
    EXPECT_THAT(sample::warnings(text), Contains(HasSubstr(" in [joint] has no effect: the joint has no "))) << text;
  }
}

TEST(IdleKeysOfTheDefaultJoint, AreNoSlipWhereAnotherJointFollowsThem) {
  const std::string other = "[[joints]]\nname = 'base'\nbetween = ['g', 'w']\nuplift = 'flow'\n";
  EXPECT_THAT(sample::warnings(scene_with("uplift = 'triangular'\nhydraulic_aperture_m = 1e-4\n", other)), IsEmpty());
}

}  // namespace
}  // namespace blockweir::scene_idle_joint_keys_test
