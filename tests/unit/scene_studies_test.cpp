// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Studies in a scene: what they say, and each message about what is wrong in them.
#include <gtest/gtest.h>

#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_studies_test {
namespace {

using blockweir::scene::sample::errors;
using blockweir::scene::sample::text;

std::string with_study(const std::string& study) {
  return text + study;
}

/// One error and no other, with these words in it.
void expect_some_error(const std::string& scene, const std::vector<std::string>& words) {
  const auto found = errors(scene);
  ASSERT_THAT(found, testing::SizeIs(1));
  for (const std::string& word : words) EXPECT_THAT(found[0], testing::HasSubstr(word));
}

TEST(SceneStudies, AllKindsAreRead) {
  const auto scene =
      blockweir::scene::read_text(
          with_study("[[limit]]\nname = 'l'\nkey = 'a.b'\nfrom = 1\nto = 2\nvalue = 1.5\ntolerance = 0.01\n"
                     "[[order]]\nname = 'o'\nkey = 'a.b'\nvalues = [1, 2, 4]\nof = 'top'\nquantity = "
                     "'displacement_m'\nvalue = "
                     "0\norder = 2\n"
                     "[[map]]\nname = 'm'\nx_key = 'a'\nx_values = [1e13]\ny_key = 'b'\ny_values = [1, 'x', "
                     "true]\nword = 'stands'\n"
                     "[[bench]]\nname = 'b'\nset = ['c=1']\nkey = 'a'\nvalues = [0.5]\n"),
          "s.toml")
          .scene;
  ASSERT_EQ(scene.studies.limits.size(), 1U);
  EXPECT_EQ(scene.studies.limits[0].width, 0.0025);
  EXPECT_EQ(scene.studies.limits[0].outcome, "fails");
  ASSERT_EQ(scene.studies.orders.size(), 1U);
  EXPECT_EQ(scene.studies.orders[0].values.size(), 3U);
  ASSERT_EQ(scene.studies.maps.size(), 1U);
  const auto& map = scene.studies.maps[0];
  EXPECT_EQ(map.expected.quantity, "mode");
  EXPECT_EQ(map.expected.word, "stands");
  EXPECT_EQ(map.may_refuse, 0);
  EXPECT_THAT(map.axes[0].values, testing::ElementsAre("1e+13"));
  EXPECT_THAT(map.axes[1].values, testing::ElementsAre("1", "x", "true"));
  ASSERT_EQ(scene.studies.benches.size(), 1U);
  EXPECT_EQ(scene.studies.benches[0].sweep.key, "a");
}

TEST(SceneStudies, AnAnswerIsStatedOnce) {
  const std::string limit = "[[limit]]\nname = 'l'\nkey = 'a'\nfrom = 1\nto = 2\n";
  expect_some_error(with_study(limit), {"[[limit]] \"l\" has no answer", "exactly one of value, word and formula"});
  expect_some_error(with_study(limit + "value = 1\nformula = 'weight-of-all'\n"), {"has both value and formula"});
}

TEST(SceneStudies, TheAnswersNamesAreKnownBeforeAnythingRuns) {
  const std::string order = "[[order]]\nname = 'o'\nkey = 'a.b'\nvalues = [1, 2, 4]\nvalue = 0\norder = 2\n";
  expect_some_error(with_study(order + "quantity = 'displacment_m'\n"),
                    {"quantity in [[order]] \"o\" is \"displacment_m\"", "did you mean \"displacement_m\"?"});
  expect_some_error(with_study("[[limit]]\nname = 'l'\nkey = 'a'\nfrom = 1\nto = 2\nformula = 'arch-tickness'\n"),
                    {"formula in [[limit]] \"l\" is \"arch-tickness\"", "did you mean \"arch-thickness\"?"});
}

TEST(SceneStudies, ALimitNeedsTwoEnds) {
  expect_some_error(with_study("[[limit]]\nname = 'l'\nkey = 'a'\nfrom = 1\nto = 1\nvalue = 1\n"),
                    {"looks for a limit from 1 to 1", "move one of them"});
  expect_some_error(with_study("[[limit]]\nname = 'l'\nkey = 'a'\nfrom = 1\nvalue = 1\n"), {"has no \"to\""});
}

TEST(SceneStudies, AnOrderNeedsThreeValues) {
  expect_some_error(with_study("[[order]]\nname = 'o'\nkey = 'a'\nvalues = [1, 2]\nof = 'top'\nquantity = "
                               "'displacement_m'\nvalue = 0\norder = 1\n"),
                    {"expected a list of at least 3"});
}

TEST(SceneStudies, ValuesOfAKeyAreNumbersFlagsOrTexts) {
  const std::string bench = "[[bench]]\nname = 'b'\nkey = 'a'\n";
  expect_some_error(with_study(bench), {"[[bench]] \"b\" has no \"values\"", "a list of at least 1"});
  expect_some_error(with_study(bench + "values = []\n"), {"values in [[bench]] \"b\" is an empty list"});
  expect_some_error(with_study(bench + "values = [[1]]\n"), {"each a finite number, true, false or a text"});
}

TEST(SceneStudies, NamesDifferAndPartsExist) {
  const std::string limit = "[[limit]]\nname = 'l'\nkey = 'a'\nfrom = 1\nto = 2\nvalue = 1\n";
  expect_some_error(with_study(limit + limit), {"a second study is called \"l\"", "rename one of them"});
  expect_some_error(with_study(limit + "of = 'nobody'\n"), {"names no block, joint or arch: \"nobody\""});
}

}  // namespace
}  // namespace blockweir::scene_studies_test
