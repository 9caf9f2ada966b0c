// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt
// The history of a run whose crack follows the level, row by row against the gravity method without tension.
#include <algorithm>
#include <cmath>
#include <map>

#include "tests/processes.hpp"

namespace blockweir::test::cracked_history_test {
namespace {

using Row = std::map<std::string, double>;

std::vector<Row> history_rows(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  const auto cells = [&] {
    std::vector<std::string> all;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) all.push_back(cell);
    return all;
  };
  std::getline(lines, line);
  const std::vector<std::string> names = cells();
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> values = cells();
    Row row;
    for (std::size_t i = 0; i < values.size(); ++i) row[names[i]] = std::strtod(values[i].c_str(), nullptr);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Bouzey's upper part: 4 m wide at the crest, 5.3 m at the joint, 10.5 m high. What stays closed of the joint is
/// b = 3 (W d - M_w - p B^2/2)/(W - p B), p the pressure at the heel; uplift is p over what is open, then linear to 0.
double normal_force(double level_m) {
  constexpr double crest_m = 4;
  constexpr double base_m = 5.3;
  constexpr double height_m = 10.5;
  constexpr double batter_m = base_m - crest_m;
  const double weight = 2100 * 9.81 * height_m * (crest_m + base_m) / 2;
  const double from_heel_m =
      (crest_m * crest_m / 2 + batter_m / 2 * (crest_m + batter_m / 3)) / ((crest_m + base_m) / 2);
  const double pressure = 9810 * level_m;
  const double held = weight * (base_m - from_heel_m) - 9810 * std::pow(level_m, 3) / 6;
  const double closed_m = std::min(base_m, 3 * (held - pressure * base_m * base_m / 2) / (weight - pressure * base_m));
  return weight - pressure * (base_m - closed_m / 2);
}

class CrackedHistory : public Processes {};

TEST_F(CrackedHistory, EachRowHasTheNormalForceAndTheUpliftOfTheCrackAtItsLevel) {
  ASSERT_EQ(shell(programs + "/blockweir run " + cases +
                  "bouzey-1895 --quiet --out r --set 'water.upstream_level_m={table=[[0,6],[10,9.9]]}'"),
            0)
      << text("out");
  const std::vector<Row> rows = history_rows(text("r/history.csv"));
  ASSERT_GT(rows.size(), 900U);
  const double dry = normal_force(0);
  for (const Row& row : rows) {
    const double expected = normal_force(row.at("upstream_level_m"));
    EXPECT_NEAR(row.at("joint.normal_force_n_per_m") / expected, 1, 1e-9) << row.at("time_s");
    EXPECT_NEAR((dry - row.at("upper part.water_force_y_n_per_m")) / expected, 1, 1e-9) << row.at("time_s");
  }
}

}  // namespace
}  // namespace blockweir::test::cracked_history_test
