// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read fmt::fmt
// Slips of units, sizes and names that would make a run without end or without sense.
#include <fmt/format.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_slips_test {
namespace {

using namespace blockweir::scene;
using sample::errors;
using sample::text;
using sample::warnings;
using sample::with;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST(SceneSlips, WindowsAndFramesWithoutEndAreRefused) {
  EXPECT_THAT(errors(with("window_s = 0.02", "window_s = 1e-300")), Contains(HasSubstr("window_s in [coupling] is")));
  for (const char* key : {"frame_every_s", "history_every_s"}) {
    const auto found = errors(with("frame_every_s = 0.5", fmt::format("{} = 1e-300", key)));
    EXPECT_THAT(found, Contains(AllOf(HasSubstr(fmt::format("{} in [output] is 1e-300 s", key)),
                                      HasSubstr("expected at most 2e+08 in a run"))));
  }
  EXPECT_THAT(errors(with("frame_every_s = 0.5", "frame_every_s = 1e-7")), testing::IsEmpty());
  EXPECT_THAT(warnings(with("frame_every_s = 0.5", "frame_every_s = 1.5e-8")), Contains(HasSubstr("1.3e+08 of them")));
}

TEST(SceneSlips, LengthsInMillimetresAndLooseTolerancesAreWarnedOf) {
  const auto analysis = [](const char* line) {
    return warnings(with("step_s = 0.01", "step_s = 0.01\n" + std::string(line)));
  };
  const auto contact = [](const char* line) {
    return warnings(with("max_iterations = 100", "max_iterations = 100\n" + std::string(line)));
  };
  EXPECT_THAT(analysis("failure_displacement_m = 28"), Contains(HasSubstr("if it is in mm, write 0.028")));
  EXPECT_THAT(analysis("failure_displacement_m = 1e300"), Contains(HasSubstr("failure_displacement_m in [analysis]")));
  EXPECT_THAT(analysis("failure_displacement_m = 0.01"), Not(Contains(HasSubstr("failure_displacement_m"))));
  EXPECT_THAT(analysis("rest_speed_m_per_s = 100"), Contains(HasSubstr("rest_speed_m_per_s in [analysis] is 100")));
  EXPECT_THAT(contact("force_tolerance = 0.1"), Contains(HasSubstr("force_tolerance in [contact] is 0.1")));
  EXPECT_THAT(contact("force_tolerance = 1e300"), Contains(HasSubstr("force_tolerance in [contact] is 1e+300")));
  EXPECT_THAT(contact("penetration_tolerance_m = 1"), Contains(HasSubstr("penetration_tolerance_m in [contact]")));
}

/// The crack lies at 2 m.
TEST(SceneSlips, PiezometerHeadsThatTheWaterDoesNotHaveAreWarnedOf) {
  const auto warned = [](double head_m) {
    return warnings(with("cohesion_pa = 1e5", fmt::format("uplift = 'heads'\npiezometers_m = [[1, {}]]\n"
                                                          "piezometers_level_m = 3",
                                                          head_m)));
  };
  EXPECT_THAT(warned(0.8), Contains(HasSubstr("has a head of 0.8 m, below the joint there, 2 m")));
  EXPECT_THAT(warned(3.2), Contains(HasSubstr("has a head of 3.2 m, above the reservoir when it was read, 3 m")));
  EXPECT_THAT(warned(2.5), Not(Contains(HasSubstr("piezometer"))));
}

TEST(SceneSlips, SiltAboveTheWaterAndFactorsInPercentAreWarnedOf) {
  const std::string silt = "[silt]\nsubmerged_density_kg_per_m3 = 900\npressure_coefficient = 0.5\nlevel_m = 3.5\n";
  EXPECT_THAT(warnings(text + silt), Contains(HasSubstr("is 3.5 m, above the highest reservoir, 3 m")));
  const std::string load_case = "[[load_case]]\nname = 'a'\nset = ['title=x']\nsource = 's'\nrequired_factor = 150\n";
  EXPECT_THAT(warnings(text + load_case), Contains(HasSubstr("if it is in percent, write 1.5")));
}

TEST(SceneSlips, AnEmptyNameOfABlockIsNotTheGround) {
  const std::string bolt =
      "[[bolt]]\nname = 'bar'\nfrom_block = 'base'\nfrom_m = [0, 1]\nto_m = [-3, 0]\nto_block = ''\n"
      "stiffness_n_per_m2 = 1e6\n";
  EXPECT_THAT(errors(text + bolt), Contains(AllOf(HasSubstr("names no block: \"\""), HasSubstr("leave to_block out"))));
}

TEST(SceneSlips, NamesAreOfALengthThatCanBeRead) {
  const std::string longest(200, 'a');
  EXPECT_THAT(errors(with("[[joints]]\nname = \"crack\"", "[[joints]]\nname = \"" + longest + "\"")),
              Not(Contains(HasSubstr("at most 200"))));
  for (const char* letter : {"a", "\u00e4"}) {
    std::string name;
    while (name.size() < 5000) name += letter;
    for (const std::string& found : errors(with("name = \"top\"", "name = \"" + name + "\""))) {
      EXPECT_LT(found.size(), 1000U);
    }
    EXPECT_THAT(errors(with("name = \"top\"", "name = \"" + name + "\"")), Contains(HasSubstr("at most 200 letters")));
  }
}

class Records : public sample::SceneFolder {};

TEST_F(Records, MayBeginWithAByteOrderMark) {
  static_cast<void>(write("a.csv",
                          "\xEF\xBB\xBF"
                          "0;1\n1;2\n2;0\n"));
  const auto scene = write("s.toml", text + "[base_motion]\nacceleration_x_m_per_s2 = { file = 'a.csv' }\n");
  const auto motion = read(scene).scene.base_motion;
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->acceleration_x_m_per_s2.at(1), 2);
}

}  // namespace
}  // namespace blockweir::scene_slips_test
