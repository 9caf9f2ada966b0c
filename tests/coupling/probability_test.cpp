// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt nlohmann_json::nlohmann_json
// What blockweir-probability draws, for [[random]] and for a [[study]] of samples alike.
#include <fmt/format.h>

#include <cmath>

#include "tests/processes.hpp"

namespace blockweir::test::probability_test {
namespace {

using nlohmann::json;

class Draws : public Processes {
 protected:
  [[nodiscard]] std::vector<std::vector<double>> drawn(const json& variables, int count, int seed = 1) const {
    const json request = {{"do", "draw"},
                          {"seed", seed},
                          {"variables", variables},
                          {"correlations", json::array()},
                          {"sampling", "monte-carlo"},
                          {"groups", 1},
                          {"count", count}};
    std::ofstream(folder / "request") << request.dump() << "\n";
    EXPECT_EQ(shell(programs + "/blockweir-probability <request"), 0) << text("out");
    return json::parse(text("out"))["answer"]["points"];
  }
  static json of(json keys) {
    keys["least"] = keys["most"] = nullptr;
    return keys;
  }
};

TEST_F(Draws, HaveTheMomentsOfTheirDistribution) {
  const double a = 1, b = 6, c = 2;  // of a triangle from a over c to b
  const double triangle = std::sqrt((a * a + b * b + c * c - a * b - a * c - b * c) / 18);
  const std::vector<std::array<double, 2>> moments{
      {35, 3}, {1e5, 5e4}, {3, 2 / std::sqrt(12.0)}, {(a + b + c) / 3, triangle}};
  const json variables = {of({{"distribution", "normal"}, {"mean", 35}, {"deviation", 3}}),
                          of({{"distribution", "lognormal"}, {"mean", 1e5}, {"deviation", 5e4}}),
                          of({{"distribution", "uniform"}, {"from", 2}, {"to", 4}}),
                          of({{"distribution", "triangular"}, {"from", a}, {"peak", c}, {"to", b}})};
  constexpr int count = 10'000;
  const auto points = drawn(variables, count);
  ASSERT_EQ(points.size(), count);
  for (std::size_t v = 0; v < moments.size(); ++v) {
    double sum = 0;
    double squares = 0;
    for (const auto& point : points) {
      sum += point[v] / count;
      squares += std::pow(point[v] - moments[v][0], 2) / count;
    }
    EXPECT_NEAR(sum, moments[v][0], 4 * moments[v][1] / std::sqrt(count)) << v;
    EXPECT_NEAR(std::sqrt(squares), moments[v][1], 0.05 * moments[v][1]) << v;
  }
}

TEST_F(Draws, OfOneSeedAreTheSameAndMoreOnlyAddToThem) {
  const json variables = {of({{"distribution", "normal"}, {"mean", 30}, {"deviation", 2}}),
                          of({{"distribution", "uniform"}, {"from", 0}, {"to", 1}})};
  const auto few = drawn(variables, 5);
  const auto many = drawn(variables, 50);
  ASSERT_EQ(few.size(), 5U);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_NE(drawn(variables, 5, 2), few);
}

}  // namespace
}  // namespace blockweir::test::probability_test
