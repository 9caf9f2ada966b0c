// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read solid_capacity
// Dams in bonded courses: high friction gives their joints many states, some of which are at rest.
#include <gtest/gtest.h>

#include <random>

#include "bridge/scene/read/read.hpp"
#include "solid/capacity/static_blocks.hpp"

namespace blockweir::test::bonded_dams_test {
namespace {

struct Dam {
  int courses;
  double course_m;
  double slope;    ///< of the downstream face: run over rise
  double brick_m;  ///< length
  double friction_deg;
};

/// Courses with bed joints from face to face and upright joints that alternate.
std::string text_of(const Dam& dam) {
  constexpr double crest_m = 3;
  const double height_m = dam.courses * dam.course_m;
  const double toe_m = crest_m + dam.slope * height_m;
  std::string text = fmt::format(R"(
analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 35 }}
material.stone = {{ youngs_modulus_pa = 8e9, poissons_ratio = 0.2, density_kg_per_m3 = 2250 }}
[section]
material = "stone"
outline_m = [[-30, -6], [60, -6], [60, 0], [{0:.6f}, 0], [{1:.6f}, {2:.6f}], [0, {2:.6f}], [-0.5, 0], [-30, 0]]
[[region]]
name = "rock"
material = "stone"
fixed = true
outline_m = [[-30, -6], [60, -6], [60, 0], [-30, 0]]
)",
                                 toe_m, crest_m, height_m);
  for (int course = 0; course < dam.courses; ++course) {
    const double y = course * dam.course_m;
    const double from_m = course == 0 ? -0.5 : -1;
    const double to_m = course == 0 ? toe_m : toe_m + 1;
    text += fmt::format("[[cut]]\nname = 'bed {}'\npoints_m = [[{:.6f}, {:.6f}], [{:.6f}, {:.6f}]]\n", course, from_m,
                        y, to_m, y);
    text += fmt::format("friction_angle_deg = {:.3f}\n", dam.friction_deg);
    const double end_m = toe_m - dam.slope * (y + dam.course_m) - 0.4 * dam.brick_m;
    for (int n = 0; dam.brick_m * (0.4 + n + 0.5 * (course % 2)) < end_m; ++n) {
      const double x = dam.brick_m * (0.4 + n + 0.5 * (course % 2));
      text += fmt::format("[[cut]]\nname = 'head {} {}'\npoints_m = [[{:.6f}, {:.6f}], [{:.6f}, {:.6f}]]\n", course, n,
                          x, y, x, y + dam.course_m);
    }
  }
  return text;
}

TEST(BondedDams, RestUnderTheirWeightWhateverTheFrictionOfTheirBeds) {
  for (const unsigned seed : {2U, 3U, 5U}) {  // Newton's method alone comes to no rest with the first
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    Dam dam;
    dam.courses = 9 + static_cast<int>(3 * share(random));
    dam.course_m = 1 + share(random);
    dam.slope = 0.5 + 0.15 * share(random);
    dam.brick_m = dam.course_m * (1 + 0.2 * share(random));
    dam.friction_deg = 55 + 10 * share(random);
    const scene::Scene scene = scene::read_text(text_of(dam), "dam").scene;
    solid::SearchBudget effort("rest");
    solid::StaticBlocks blocks(scene, nullptr, effort);
    EXPECT_TRUE(blocks.begin(0)) << text_of(dam);
  }
}

}  // namespace
}  // namespace blockweir::test::bonded_dams_test
