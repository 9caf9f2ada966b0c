// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "bridge/results/counted.hpp"
#include "bridge/results/csv.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/probability.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using Row = std::vector<std::string>;

/// A file of values: its heading, and the cells of each row below.
struct ValueTable {
  std::string name;  ///< as the scene states it
  Row heading;
  std::vector<Row> rows;
};

[[noreturn]] void refuse(const scene::OpenStudy& study, const fs::path& scene, const std::string& found,
                         const std::string& expected, const std::string& remedy) {
  throw scene::SceneError({{scene::Diagnostic::Severity::error, scene::scene_file(scene).string(), study.line,
                            fmt::format("[[study]] \"{}\": {}", study.name, found), expected, remedy}});
}

Row cells_of(std::string line) {
  if (line.ends_with('\r')) line.pop_back();
  Row cells = results::csv_cells(line);
  for (std::string& cell : cells) {
    const auto from = cell.find_first_not_of(" \t");
    cell = from == std::string::npos ? "" : cell.substr(from, cell.find_last_not_of(" \t") - from + 1);
  }
  return cells;
}

ValueTable read_table(const scene::OpenStudy& study, const fs::path& scene, const std::string& name) {
  const fs::path file = scene::scene_file(scene).parent_path() / name;
  std::error_code failed;
  std::ifstream stream(file);
  if (!fs::is_regular_file(file, failed) || !stream) {
    refuse(study, scene, fmt::format("the file {} cannot be read", name),
           "a CSV file with a heading, its path from the scene's folder", "check the path");
  }
  ValueTable table{.name = name};
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    Row cells = cells_of(line);
    if (table.heading.empty()) {
      if (cells[0].starts_with("\xef\xbb\xbf")) cells[0].erase(0, 3);  // of spreadsheets
      for (auto cell = cells.begin(); cell != cells.end(); ++cell) {
        if (cell->empty() || std::find(cells.begin(), cell, *cell) == cell) continue;
        refuse(study, scene, fmt::format("line {} of {}, its heading, has \"{}\" twice", number, name, *cell),
               "each column's name once", "rename or delete one of the columns");
      }
      table.heading = std::move(cells);
    } else if (cells.size() != table.heading.size()) {
      refuse(study, scene, fmt::format("line {} of {} has {}", number, name, results::counted(cells.size(), "cell")),
             fmt::format("{}, as the heading has", table.heading.size()), "correct the file");
    } else {
      table.rows.push_back(std::move(cells));
    }
  }
  if (table.rows.empty()) {
    refuse(study, scene, fmt::format("the file {} has no rows", name), "a heading, and a row for each run",
           "correct the file");
  }
  return table;
}

/// The column's place; only values that are there will do.
std::size_t column_of(const scene::OpenStudy& study, const fs::path& scene, const ValueTable& table,
                      const std::string& column) {
  const auto found = std::find(table.heading.begin(), table.heading.end(), column);
  if (found == table.heading.end()) {
    const std::string near = scene::did_you_mean(column, table.heading);
    refuse(study, scene, fmt::format("{} has no column \"{}\"", table.name, column), scene::one_of(table.heading),
           near.empty() ? "name another column, or state the variable's distribution" : near);
  }
  const auto at = static_cast<std::size_t>(found - table.heading.begin());
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (!table.rows[row][at].empty()) continue;
    refuse(study, scene, fmt::format("row {} of {} has nothing for \"{}\"", row + 1, table.name, column),
           "a value in each row", "correct the file");
  }
  return at;
}

/// Values of the variables that have a distribution, run by run.
std::vector<RandomPoint> drawn_points(const scene::OpenStudy& study, const fs::path& scene, std::size_t runs) {
  const auto& sample = std::get<scene::Sample>(study.question);
  std::vector<scene::Distribution> distributions;
  for (const scene::Variable& variable : sample.variables) {
    if (variable.distribution) distributions.push_back(*variable.distribution);
  }
  if (distributions.empty()) return std::vector<RandomPoint>(runs);
  try {
    Probability probability(distributions, sample.seed);
    return probability.ask({{"do", "draw"}, {"sampling", "monte-carlo"}, {"groups", 1}, {"count", runs}})["points"];
  } catch (const std::runtime_error& error) {
    refuse(study, scene, error.what(), "distributions that OpenTURNS draws from", "correct their keys");
  }
}

}  // namespace

std::vector<Settings> drawn_settings(const scene::OpenStudy& study, const fs::path& scene) {
  const auto& sample = std::get<scene::Sample>(study.question);
  ValueTable table;
  if (!sample.file.empty()) table = read_table(study, scene, sample.file);
  const auto runs = static_cast<std::size_t>(sample.runs);
  if (!sample.file.empty() && runs > table.rows.size()) {
    refuse(study, scene, fmt::format("runs = {}, and {} has {} rows", runs, sample.file, table.rows.size()),
           "a row for each run", "leave runs out, or add rows");
  }
  std::vector<std::size_t> columns(sample.variables.size());
  for (std::size_t v = 0; v < columns.size(); ++v) {
    const scene::Variable& variable = sample.variables[v];
    if (variable.distribution) continue;
    columns[v] = column_of(study, scene, table, variable.column);
  }
  const std::vector<RandomPoint> points = drawn_points(study, scene, runs > 0 ? runs : table.rows.size());
  std::vector<Settings> all(points.size());
  for (std::size_t run = 0; run < all.size(); ++run) {
    auto drawn = points[run].begin();
    for (std::size_t v = 0; v < columns.size(); ++v) {
      const scene::Variable& variable = sample.variables[v];
      all[run].push_back(variable.distribution ? setting(variable.key, *drawn++)
                                               : variable.key + "=" + table.rows[run][columns[v]]);
    }
  }
  return all;
}

}  // namespace blockweir::study
