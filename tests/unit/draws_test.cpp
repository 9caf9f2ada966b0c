// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_study
// What a sample sets its keys to.
#include "bridge/study/draws.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "bridge/scene/diagnostic.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::study {
namespace {

using scene::Distribution;
using scene::Variable;
using testing::HasSubstr;

/// Mean and standard deviation by the midpoint rule over the shares of all draws.
std::array<double, 2> moments(const Variable& variable) {
  constexpr int cells = 200'000;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < cells; ++i) {
    const double value = quantile(variable, (i + 0.5) / cells);
    sum += value / cells;
    squares += value * value / cells;
  }
  return {sum, std::sqrt(squares - sum * sum)};
}

TEST(Draws, HaveTheMomentsOfTheirDistribution) {
  const auto expect = [](const Variable& variable, double mean, double deviation) {
    const auto [m, d] = moments(variable);
    EXPECT_NEAR(m, mean, 1e-3 * std::abs(mean));
    EXPECT_NEAR(d, deviation, 1e-3 * deviation);
  };
  expect({.distribution = Distribution::normal, .mean = 35, .deviation = 3}, 35, 3);
  expect({.distribution = Distribution::lognormal, .mean = 1e5, .deviation = 5e4}, 1e5, 5e4);
  expect({.distribution = Distribution::uniform, .from = 2, .to = 4}, 3, 2 / std::sqrt(12.0));
  const double a = 1, b = 6, c = 2;  // of a triangle from a over c to b
  expect({.distribution = Distribution::triangular, .from = a, .peak = c, .to = b}, (a + b + c) / 3,
         std::sqrt((a * a + b * b + c * c - a * b - a * c - b * c) / 18));
}

class DrawnSettings : public test::OwnFolder {
 protected:
  [[nodiscard]] std::vector<Settings> drawn(scene::Sample sample) const {
    return drawn_settings({.name = "s", .line = 7, .question = std::move(sample)}, folder / "scene.toml");
  }
  [[nodiscard]] std::string refusal(const std::string& csv, int runs = 0) const {
    std::ofstream(folder / "v.csv") << csv;
    try {
      (void)drawn({.runs = runs, .file = "v.csv", .variables = {{.key = "a.b", .column = "phi"}}});
    } catch (const scene::SceneError& error) {
      return error.what();
    }
    return "none";
  }
};

TEST_F(DrawnSettings, OfOneSeedAreTheSameAndMoreRunsAddToThem) {
  const Variable phi{.key = "phi", .distribution = Distribution::normal, .mean = 30, .deviation = 2};
  const Variable c{.key = "c", .distribution = Distribution::uniform, .from = 0, .to = 1};
  const auto few = drawn({.runs = 5, .variables = {phi, c}});
  const auto many = drawn({.runs = 50, .variables = {phi, c}});
  ASSERT_EQ(few.size(), 5U);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_NE(drawn({.runs = 5, .seed = 2, .variables = {phi, c}}), few);
  EXPECT_THAT(few[0], testing::ElementsAre(testing::StartsWith("phi="), testing::StartsWith("c=0.")));
}

TEST_F(DrawnSettings, ComeFromAFileAsASpreadsheetWritesIt) {
  std::ofstream(folder / "v.csv") << "\xef\xbb\xbfphi, note\r\n30,\"dry, rough\"\r\n\r\n31.5,wet\r\n";
  scene::Sample sample{.file = "v.csv", .variables = {{.key = "a.b", .column = "phi"}}};
  EXPECT_THAT(drawn(sample), testing::ElementsAre(Settings{"a.b=30"}, Settings{"a.b=31.5"}));
}

TEST_F(DrawnSettings, AFileThatIsWrongIsRefusedAtTheStudy) {
  EXPECT_THAT(refusal("Phi,c\n1,2\n"), testing::AllOf(HasSubstr("scene.toml:7: error: [[study]] \"s\": v.csv has no "
                                                                "column \"phi\"; expected one of Phi, c"),
                                                      HasSubstr("did you mean \"Phi\"?")));
  EXPECT_THAT(refusal("phi,c\n1\n"), HasSubstr("line 2 of v.csv has 1 cells; expected 2"));
  EXPECT_THAT(refusal("phi,c\n,2\n"), HasSubstr("row 1 of v.csv has nothing for \"phi\""));
  EXPECT_THAT(refusal("phi\n"), HasSubstr("has no rows"));
  EXPECT_THAT(refusal("phi\n1\n", 2), HasSubstr("runs = 2, and v.csv has 1 rows"));
  std::filesystem::remove(folder / "v.csv");
  scene::Sample sample{.file = "w.csv", .variables = {{.key = "a", .column = "a"}}};
  EXPECT_THROW((void)drawn(sample), scene::SceneError);
}

}  // namespace
}  // namespace blockweir::study
