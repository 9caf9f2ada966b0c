// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_expect
// Limit analysis of arches against published values and geometry.
#include <gtest/gtest.h>

#include "solid/expect/formulas.hpp"

namespace blockweir::solid::expect::formulas_masonry_test {
namespace {

double arch_thickness(int voussoirs, double mean_radius_m, double embrace_deg) {
  scene::Scene scene;
  scene.arches.push_back(
      {.name = "arch", .mean_radius_m = mean_radius_m, .embrace_deg = embrace_deg, .voussoirs = voussoirs});
  return formula(scene, {.formula = "arch-thickness", .of = "arch"});
}

TEST(ArchThickness, OfManyVoussoirsIsThatOfMilankovitch) {
  EXPECT_NEAR(arch_thickness(1000, 1, 180), 0.107478, 2e-6);
  EXPECT_NEAR(arch_thickness(1001, 1, 180), 0.107478, 2e-6);
}

TEST(ArchThickness, GrowsWithTheRadiusAlone) {
  EXPECT_NEAR(arch_thickness(20, 10, 180) / arch_thickness(20, 1, 180), 10, 1e-9);
}

TEST(ArchThickness, IsLessWhereHingesCannotFormAnywhere) {
  for (const int n : {5, 8, 12, 20, 21}) EXPECT_LT(arch_thickness(n, 1, 180), 0.1075) << n;
}

TEST(ArchThickness, IsLessForAShallowArch) {
  EXPECT_LT(arch_thickness(40, 1, 120), arch_thickness(40, 1, 150));
  EXPECT_LT(arch_thickness(40, 1, 150), arch_thickness(40, 1, 180));
}

TEST(ArchThickness, OfAnArchThatIsNotThereIsAnError) {
  EXPECT_THROW(formula({}, {.formula = "arch-thickness", .of = "arch"}), std::runtime_error);
}

TEST(ArchThickness, UnderTiltedGravityIsAnError) {
  scene::Scene scene;
  scene.arches.push_back({.name = "arch", .mean_radius_m = 1, .voussoirs = 8});
  EXPECT_NO_THROW(formula(scene, {.formula = "arch-thickness", .of = "arch"}));
  scene.analysis.gravity_tilt_deg = 5;
  EXPECT_THROW(formula(scene, {.formula = "arch-thickness", .of = "arch"}), std::runtime_error);
}

}  // namespace
}  // namespace blockweir::solid::expect::formulas_masonry_test
