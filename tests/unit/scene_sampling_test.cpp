// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Courses in time that go on between two looks of the run: what it would not see is warned of.
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_sampling_test {
using namespace blockweir::scene;
using sample::expect_error;
using sample::expect_warning;
using sample::text;
using sample::warnings;
using sample::with;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

/// The sample in windows of half a second.
std::string with_level(const std::string& level) {
  return with("{ table = [[0, 1], [2, 3]] }", level, with("window_s = 0.02", "window_s = 0.5"));
}

/// Serial and parallel schedules cut their windows there; the improved one looks at middles.
TEST(SceneSampling, ALevelThatPeaksBetweenTwoWindows) {
  const std::string peak = with_level("{ table = [[0, 1], [0.6, 1], [0.8, 1.5], [0.98, 1]] }");
  EXPECT_THAT(warnings(peak), IsEmpty());
  const auto improved = [](const std::string& scene) {
    return with("window_s = 0.5", "window_s = 0.5\nschedule = \"improved\"", scene);
  };
  expect_error(improved(peak), 45,
               {"upstream_level_m in [water] is 1.5 at 0.8 s, which the run does not read", "at 0.5 s and 1 s",
                "shorten [coupling] window_s"});
  expect_error(improved(with_level("{ steps = [[0, 1], [0.6, 1.5], [0.9, 1]] }")), 45, {"is 1.5 at 0.6 s"});
}

TEST(SceneSampling, RowsThatAWindowBeginsWithOrRisesThroughAreSeen) {
  EXPECT_THAT(warnings(with_level("{ table = [[0, 1], [0.5, 1.5], [1, 1]] }")), IsEmpty());
  EXPECT_THAT(warnings(with_level("{ table = [[0, 1], [0.6, 1.2], [2, 3]] }")), IsEmpty());
  EXPECT_THAT(warnings(with_level("{ steps = [[0, 1], [0.6, 1.5], [1.2, 1]] }")), IsEmpty());
}

TEST(SceneSampling, ASineThatIsFasterThanTenLooks) {
  const std::string waves = with_level("{ sine = 0.5, frequency_hz = 1, mean = 2 }");
  expect_error(waves, 45,
               {"crests of upstream_level_m in [water] are up to 0.5 m above the values that the run reads",
                "up to 0.003 m, a thousandth of the water's depth", "shorten [coupling] window_s to 0.035 s"});
  EXPECT_THAT(warnings(with("window_s = 0.5", "window_s = 0.02", waves)), IsEmpty());
  const std::string pulse = "force_x_n_per_m = { sine = 100, frequency_hz = 25 }\nforce_y_n_per_m = 0";
  EXPECT_THAT(warnings(with("force_n_per_m = [100, -200]", pulse)),
              Contains(HasSubstr("a period of force_x_n_per_m in [[point_load]] takes 0.04 s, 4 times [analysis] "
                                 "step_s, 0.01 s: its course is not followed")));
}

/// Steps of a dynamic analysis take up the rows' mean; one that looks for rest has no impulse.
TEST(SceneSampling, ALoadThatComesAndGoesWithinAStep) {
  const std::string pulse =
      "force_x_n_per_m = { table = [[0, 0], [0.101, 0], [0.105, 900], [0.109, 0]] }\n"
      "force_y_n_per_m = 0";
  const std::string pushed = with("force_n_per_m = [100, -200]", pulse);
  EXPECT_THAT(warnings(pushed), IsEmpty());
  expect_error(with("duration_s = 2.0", "duration_s = 2.0\nkind = \"quasi-static\"", pushed), 39,
               {"force_x_n_per_m in [[point_load]] is 900 at 0.105 s, which the run does not read"});
  EXPECT_THAT(warnings(with("duration_s = 2.0", "duration_s = 2.0\nkind = \"static\"", pushed)),
              Not(Contains(HasSubstr("which the run does not read"))));
}

TEST(SceneSampling, ASupportThatIsMovedToAndFroWithinAStep) {
  expect_error(
      with("displacement_x_m = 0", "displacement_x_m = { table = [[0, 0], [0.101, 0], [0.105, 0.01], [0.109, 0]] }"),
      34, {"displacement_x_m in [[support]] is 0.01 at 0.105 s, which the run does not read"});
}

/// No block follows a jump; a fast path it does follow, in shorter steps, but few engineers mean one.
TEST(SceneSampling, ASupportThatLeapsOrFlies) {
  const auto led = [](const std::string& path) { return with("displacement_x_m = 0", "displacement_x_m = " + path); };
  expect_warning(led("{ steps = [[0, 0], [1, 0.05]] }"), 34,
                 {"displacement_x_m in [[support]] leaps by 0.05 m at 1 s: no block follows a jump",
                  "jumps of at most failure_displacement_m, 0.004 m"});
  expect_warning(led("{ sine = 20, frequency_hz = 0.5 }"), 34,
                 {"displacement_x_m in [[support]] goes 0.6282 m from",
                  "within step_s, 0.01 s, which is unusual: 62.8 m/s, of block \"base\" at (0, 0) m", "up to 0.02 m",
                  "write values that are in mm as m"});
  EXPECT_THAT(warnings(led("{ steps = [[0, 0], [1, 0.001]] }")), IsEmpty());
  EXPECT_THAT(warnings(led("{ sine = 0.02, frequency_hz = 0.5 }")), IsEmpty());
  EXPECT_THAT(warnings(with("duration_s = 2.0", "duration_s = 2.0\nkind = \"static\"", led("0.05"))), IsEmpty());
}

/// By a sine of 2 Hz windows of 0.1 s lose 1 - (sin(x)/x)^2 of its power, x = pi f w.
TEST(SceneSampling, ARecordThatIsFastAgainstTheWindowsOfAReservoir) {
  const auto shaken = [](const std::string& window_s) {
    const std::string motion = "[base_motion]\nacceleration_x_m_per_s2 = { sine = 1, frequency_hz = 2 }\n[fluid]\n";
    return with("window_s = 0.02", "window_s = " + window_s,
                with("[fluid]\nmodel = \"hydrostatic\"", motion + "model = \"reservoir\""));
  };
  const auto said =
      Contains(HasSubstr("windows of 0.1 s are long against the record of [base_motion]: the reservoir "
                         "answers to its means over windows, which lack 12.4 % of its power"));
  EXPECT_THAT(warnings(shaken("0.1")), said);
  EXPECT_THAT(warnings(shaken("0.02")), Not(Contains(HasSubstr("long against the record"))));
}

}  // namespace
}  // namespace blockweir::scene_sampling_test
