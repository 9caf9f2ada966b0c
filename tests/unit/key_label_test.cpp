// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_study
// Keys as words at the axes of pictures.
#include "bridge/study/key_label.hpp"

#include <gtest/gtest.h>

namespace blockweir::study::key_label_test {
namespace {

TEST(KeyLabel, HasWordsAndAUnit) {
  EXPECT_EQ(key_label("joints.bedding.cohesion_pa"), "joints bedding: cohesion (Pa)");
  EXPECT_EQ(key_label("joint_set.my_set.friction_angle_deg"), "joint set my_set: friction angle (deg)");
  EXPECT_EQ(key_label("material.rock.density_kg_per_m3"), "material rock: density (kg/m³)");
  EXPECT_EQ(key_label("joint_flow.viscosity_pa_s"), "joint flow: viscosity (Pa s)");
  EXPECT_EQ(key_label("water.upstream_level_m"), "water: upstream level (m)");
}

TEST(KeyLabel, LeavesOutWhatIsNotThere) {
  EXPECT_EQ(key_label("material.rock.poissons_ratio"), "material rock: poissons ratio");
  EXPECT_EQ(key_label("k"), "k");
  EXPECT_EQ(key_label("expect.1.tolerance"), "expect 1: tolerance");
}

}  // namespace
}  // namespace blockweir::study::key_label_test
