// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// [earthquake] beside [base_motion]: twice the same in a run, one of the two in a static answer.
#include "bridge/scene/two_earthquakes.hpp"

#include "bridge/scene/read/stated_loads.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::two_earthquakes_test {
using namespace blockweir::scene;
using sample::text;
using sample::warnings;
using sample::with;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

namespace {

/// Of runs; a load case of `safety` may well state the coefficients of a scene that shakes.
TEST(TwoEarthquakes, ARunWithAnEarthquakeByCoefficientsAndByItsMotionIsAWarning) {
  const std::string shaken = "[base_motion]\nacceleration_x_m_per_s2 = { sine = 1, frequency_hz = 2 }\n";
  const auto twice = [&](const std::string& coefficient, const std::string& kind) {
    const std::string both = shaken + "[earthquake]\nhorizontal_coefficient = " + coefficient + "\n";
    const std::string scene = with("duration_s = 2.0", "duration_s = 2.0\nkind = \"" + kind + "\"", text + both);
    EXPECT_THAT(warnings(scene), Not(Contains(HasSubstr("twice"))));
    return two_earthquakes(read_text(scene, "s.toml").scene);
  };
  ASSERT_TRUE(twice("0.1", "dynamic"));
  EXPECT_THAT(
      twice("0.1", "dynamic")->text(),
      HasSubstr("s.toml: warning: a run has the earthquake twice: the constant coefficients of [earthquake] act "
                "all along, beside [base_motion]; expected [base_motion] in a run, [earthquake] in a static "
                "answer; leave one of the two out"));
  EXPECT_FALSE(twice("0.1", "static"));
  EXPECT_FALSE(twice("0", "dynamic"));
}

TEST(TwoEarthquakes, GroundThatHasComeToRestIsNoLoadOfTheEnd) {
  const auto loads = [](const std::string& rows) {
    return stated_loads(read_text(text + "[base_motion]\nacceleration_x_m_per_s2 = { table = " + rows +
                                      " }\n[earthquake]\nhorizontal_coefficient = 0.1\n",
                                  "s.toml")
                            .scene);
  };
  EXPECT_THAT(loads("[[0, 0], [1, 3], [1.5, 0]]"), ElementsAre("[[point_load]]", "[[face_pressure]]", "[earthquake]"));
  EXPECT_THAT(loads("[[0, 0], [2, 3]]"),
              ElementsAre("[[point_load]]", "[[face_pressure]]", "[earthquake]", "[base_motion]"));
}

}  // namespace
}  // namespace blockweir::two_earthquakes_test
