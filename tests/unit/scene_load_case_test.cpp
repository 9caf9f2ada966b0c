// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// [[load_case]]: what is read, and what is refused.
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_load_case_test {
namespace {

using namespace blockweir::scene;
using testing::HasSubstr;

class LoadCases : public sample::SceneFolder {
 protected:
  [[nodiscard]] std::filesystem::path with(const std::string& load_cases) const {
    return write("s.toml", sample::text + load_cases);
  }
};

TEST_F(LoadCases, AreReadWithTheirClassAndRequiredFactor) {
  const ReadScene scene =
      read(with("[[load_case]]\nname = 'flood'\nclass = 'unusual'\nset = ['joint.friction_angle_deg=20']\n"
                "required_factor = 1.3\nsource = 'guideline'\n[[load_case]]\nname = 'dry'\nset = ['title=x']\n"));
  ASSERT_THAT(scene.load_cases, testing::SizeIs(2));
  EXPECT_EQ(scene.load_cases[0].name, "flood");
  EXPECT_EQ(scene.load_cases[0].kind, "unusual");
  EXPECT_EQ(scene.load_cases[0].required_factor, 1.3);
  EXPECT_EQ(scene.load_cases[0].source, "guideline");
  EXPECT_EQ(scene.load_cases[1].required_factor, std::nullopt);
}

TEST_F(LoadCases, ARequiredFactorNeedsItsSource) {
  EXPECT_THAT(error(with("[[load_case]]\nname = 'flood'\nset = ['title=x']\nrequired_factor = 1.3\n")),
              testing::AllOf(HasSubstr("s.toml:59: error: "), HasSubstr("has a required_factor and no source")));
  EXPECT_THAT(error(with("[[load_case]]\nname = 'flood'\nset = ['title=x']\nsource = 'guideline'\n")),
              HasSubstr("has a source and no required_factor"));
  EXPECT_THAT(error(with("[[load_case]]\nname = 'x'\nset = []\nrequired_factor = '1.5'\nsource = 'rule'\n")),
              testing::Not(HasSubstr("has a source and no required_factor")))
      << "one slip, one error";
}

TEST_F(LoadCases, TheSceneAsWrittenIsALoadCaseWithAnEmptySet) {
  const ReadScene scene = read(
      with("[[load_case]]\nname = 'normal'\nclass = 'usual'\nset = []\nrequired_factor = 1.5\nsource = 'guideline'\n"));
  ASSERT_THAT(scene.load_cases, testing::SizeIs(1));
  EXPECT_THAT(scene.load_cases[0].set, testing::IsEmpty());
  EXPECT_THAT(error(with("[[variant]]\nname = 'a'\nset = []\n")), HasSubstr("state what it changes"));
}

TEST_F(LoadCases, SetAKeyOnce) {
  const auto set = [&](const std::string& two) {
    return error(with("[[load_case]]\nname = 'a'\nset = [" + two + "]\n"));
  };
  EXPECT_THAT(set("'water.upstream_level_m=3', 'water.upstream_level_m=1'"),
              HasSubstr("s.toml:58: error: set in [[load_case]] \"a\" has \"water.upstream_level_m=3\" and "
                        "\"water.upstream_level_m=1\"; expected each key once"));
  EXPECT_THAT(set("'block.base.fixed=true', 'block.1.fixed=false'"), HasSubstr("expected each key once"));
}

TEST_F(LoadCases, NeedANameOfTheirOwnAndSomethingThatTheySet) {
  EXPECT_THAT(error(with("[[load_case]]\nset = ['title=x']\n")), HasSubstr("name"));
  EXPECT_THAT(error(with("[[load_case]]\nname = 'flood'\n")), HasSubstr("set"));
  EXPECT_THAT(
      error(with("[[load_case]]\nname = 'a'\nset = ['title=x']\n[[load_case]]\nname = 'a'\nset = ['title=x']\n")),
      HasSubstr("a second load case is called \"a\", as that of line 57"));
  EXPECT_THAT(error(with("[[load_case]]\nname = 'a'\nset = ['title=x']\nrequired_factr = 2\n")),
              HasSubstr("did you mean \"required_factor\"?"));
}

}  // namespace
}  // namespace blockweir::scene_load_case_test
