// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_output fluid_hydrostatic bridge_scene_read
// A crest that is level, that tilts by less than is seen, and that slopes: what presses on it, and what is said of it.
#include "bridge/scene/crest.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bridge/scene/read/read.hpp"
#include "solid/output/water_on_crest.hpp"
#include "tests/still_water.hpp"

namespace blockweir::crest_test {
namespace {

using testing::HasSubstr;

/// A dam of 10 m on 20 m of rock, whose crest of 6 m rises or falls downstream.
scene::Scene dam(double downstream_corner_m, const char* law) {
  return scene::read_text(fmt::format(R"(analysis = {{ duration_s = 1 }}
water = {{ upstream_level_m = 12, may_overtop = true, crest_pressure = "{}" }}
material.m = {{ youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2300 }}
joint = {{ friction_angle_deg = 45 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-30, -20], [50, -20], [50, 0], [-30, 0]]
[[block]]
name = "dam"
material = "m"
vertices_m = [[0, 0], [10, 0], [6, {}], [0, 10]]
)",
                                      law, downstream_corner_m),
                          "s.toml")
      .scene;
}

double weight_on_crest(double corner_m, const char* law) {
  const scene::Scene scene = dam(corner_m, law);
  return -tests::resultant(scene, tests::load_at_rest(scene), 1).force.y();
}

TEST(Crest, BearsWhatIsStatedWhereItTiltsByLessThanIsSeen) {
  for (const double corner : {9.95, 9.99, 10.0, 10.005, 10.02, 10.055}) {
    EXPECT_EQ(scene::crest_of(dam(corner, "none").blocks).edges.size(), 1U) << corner;
    EXPECT_NEAR(weight_on_crest(corner, "none"), 0, 1e-6) << corner;
    EXPECT_NEAR(weight_on_crest(corner, "full") / (2 * 9810 * 6), 1, 0.03) << corner;
    EXPECT_NEAR(weight_on_crest(corner, "triangular") / (9810 * 6), 1, 0.03) << corner;
    EXPECT_THAT(solid::output::water_on_crest_warning(dam(corner, "none"), 12), HasSubstr("is left out")) << corner;
    EXPECT_EQ(solid::output::water_on_crest_warning(dam(corner, "full"), 12), "") << corner;
  }
}

TEST(Crest, ThatSlopesIsAFaceOfTheDamAndThatIsSaid) {
  for (const char* law : {"none", "triangular", "full"}) {
    EXPECT_NEAR(weight_on_crest(10.1, law), 9810 * (2 + 1.9) / 2 * 6, 9810 * 6 * 0.02) << law;
    EXPECT_NEAR(weight_on_crest(9.9, law), 0, 1e-6) << law;
    for (const double corner : {9.9, 10.1}) {
      EXPECT_TRUE(scene::crest_of(dam(corner, law).blocks).edges.empty());
      EXPECT_THAT(solid::output::water_on_crest_warning(dam(corner, law), 12),
                  HasSubstr("above the structure's highest point, which is on no level crest"));
    }
  }
}

}  // namespace
}  // namespace blockweir::crest_test
