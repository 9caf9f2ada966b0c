// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// [[study]]: what is read, and what is refused.
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_open_studies_test {
namespace {

using namespace blockweir::scene;
using sample::errors;

const std::string critical = "[[study]]\nname = 'c'\nkind = 'critical'\nkey = 'a'\nfrom = 1\nto = 2\n";
const std::string drawn = "[[study]]\nname = 's'\nkind = 'sample'\nruns = 10\n";

void expect_one_error(const std::string& study, const std::vector<std::string>& words) {
  const auto found = errors(sample::text + study);
  ASSERT_THAT(found, testing::SizeIs(1)) << study;
  for (const std::string& word : words) EXPECT_THAT(found[0], testing::HasSubstr(word));
}

TEST(SceneOpenStudies, AllKindsAreRead) {
  const std::vector<OpenStudy> studies =
      read_text(sample::text + critical +
                    "[[study]]\nname = 'm'\nkind = 'map'\nx_key = 'a'\nx_values = [1, 2]\ny_key = 'b'\ny_values = "
                    "['x']\n" +
                    drawn +
                    "variable = [{ key = 'a', distribution = 'triangular', from = 1, peak = 2, to = 4 }, { key = 'b', "
                    "distribution = 'lognormal', mean = 3, deviation = 1 }]\n",
                "s.toml")
          .open_studies;
  ASSERT_THAT(studies, testing::SizeIs(3));
  const auto& value = std::get<CriticalValue>(studies[0].question);
  EXPECT_EQ(value.outcome, "fails");
  EXPECT_EQ(value.width, 1e-3);
  EXPECT_EQ(std::get<OutcomeMap>(studies[1].question).axes[1].values, std::vector<std::string>{"x"});
  const auto& sample = std::get<Sample>(studies[2].question);
  ASSERT_THAT(sample.variables, testing::SizeIs(2));
  EXPECT_EQ(sample.variables[0].distribution->kind, "triangular");
  EXPECT_EQ(sample.variables[1].distribution->deviation, 1);
}

TEST(SceneOpenStudies, ACriticalFactorHasATargetAndNothingElseDoes) {
  const auto studies = read_text(sample::text + critical + "outcome = 'factor'\ntarget = 1.5\n", "s.toml").open_studies;
  EXPECT_EQ(std::get<CriticalValue>(studies.at(0).question).target, 1.5);
  expect_one_error(critical + "outcome = 'factor'\n",
                   {"[[study]] \"c\" has no target", "factor of safety that is to be reached", "add target = 1.5"});
  expect_one_error(critical + "target = 1.5\n",
                   {"target in [[study]] \"c\", whose outcome is \"fails\"", "leave target out"});
  expect_one_error(critical + "outcome = 'factor'\ntarget = 0\n", {"target", "above 0"});
}

TEST(SceneOpenStudies, ADistributionHasAWidth) {
  const auto with = [](const std::string& variable) {
    return drawn + "variable = [{ key = 'a', " + variable + " }]\n";
  };
  expect_one_error(with("distribution = 'normal', mean = 3"),
                   {"s.toml:60: error: variable 1 of [[study]] \"s\" has no \"deviation\"", "add deviation = ..."});
  for (const char* none : {"0", "-0.0", "-2", "-1e-300"}) {
    expect_one_error(with(std::string("distribution = 'normal', mean = 3, deviation = ") + none),
                     {"deviation in variable 1", "a standard deviation above 0"});
  }
  expect_one_error(with("distribution = 'uniform', from = 3, to = 3"), {"goes from 3 to 3", "widen the distribution"});
  expect_one_error(with("distribution = 'triangular', from = 1, peak = 5, to = 4"), {"peak", "a value from 1 to 4"});
  expect_one_error(with("distribution = 'normel', mean = 3"), {"did you mean \"normal\"?"});
  expect_one_error(with("distribution = 'normal', mean = 3, deviation = 1, to = 4"), {"to in variable 1"});
  expect_one_error(with("mean = 3"), {"variable 1 of [[study]] \"s\" has no distribution"});
  expect_one_error(drawn + "file = 'v.csv'\nvariable = [{ key = 'a', mean = 3 }]\n",
                   {"mean in variable 1 of [[study]] \"s\", which is a column of the study's file", "leave mean out"});
}

TEST(SceneOpenStudies, AVariableIsDrawnOrReadFromAFile) {
  expect_one_error(drawn + "variable = [{ key = 'a' }]\n", {"has no distribution", "file = \"FILE.csv\""});
  EXPECT_TRUE(errors(sample::text + drawn + "file = 'v.csv'\nvariable = [{ key = 'a', column = 'phi' }]\n").empty());
  expect_one_error(drawn +
                       "file = 'v.csv'\nvariable = [{ key = 'a', column = 'phi', distribution = 'uniform', from = 1, "
                       "to = 2 }]\n",
                   {"column in variable 1", "has a distribution", "leave one of them out"});
  expect_one_error(
      "[[study]]\nname = 's'\nkind = 'sample'\nvariable = [{ key = 'a', distribution = 'uniform', from = "
      "1, to = 2 }]\n",
      {"has neither runs nor a file"});
  expect_one_error(drawn, {"has no \"variable\""});
}

TEST(SceneOpenStudies, KeysOfAnotherKindAreRefused) {
  expect_one_error(critical + "runs = 3\n", {"runs in [[study]] \"c\", which is a critical study", "leave runs out"});
  expect_one_error(critical + "kei = 3\n", {"unknown key \"kei\"", "did you mean \"key\"?"});
  expect_one_error("[[study]]\nname = 'c'\nkind = 'criticl'\n", {"did you mean \"critical\"?"});
}

TEST(SceneOpenStudies, AKeyIsNotBothVariedAndSet) {
  expect_one_error(critical + "set = ['a=3']\n", {"varies \"a\", and states \"a=3\" beside it"});
  expect_one_error(critical + "set = ['b=3', 'b=4']\n", {"has \"b=3\" and \"b=4\"", "each key once"});
}

TEST(SceneOpenStudies, NamesDifferFromThoseOfAllStudies) {
  expect_one_error(critical + critical, {"a second study is called \"c\""});
  expect_one_error(critical + "[[limit]]\nname = 'c'\nkey = 'a'\nfrom = 1\nto = 2\nvalue = 1\n",
                   {"a second study is called \"c\""});
  expect_one_error("[[study]]\nname = 'c'\nkind = 'critical'\nkey = 'a'\nfrom = 1\nto = 1\n", {"goes from 1 to 1"});
}

}  // namespace
}  // namespace blockweir::scene_open_studies_test
