// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/flow_files.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "bridge/results/csv.hpp"

namespace blockweir::picture {

Rows flow_rows(const std::filesystem::path& run, const std::string& name, const nlohmann::json& summary) {
  const double failure_s = summary.contains("failure") ? summary["failure"]["time_s"].get<double>()
                                                       : std::numeric_limits<double>::infinity();
  Rows rows;
  const std::filesystem::path file = run / name;
  std::ifstream stream(std::filesystem::exists(file) ? file : run / "openfoam" / name);
  for (std::string line; std::getline(stream, line);) {
    rows.push_back(results::csv_cells(line));
    if (rows.back().size() != rows.front().size()) rows.pop_back();
    if (rows.size() < 3 || rows.back()[0] == rows[1][0]) continue;  // the first moment stays in any case
    if (number_in(rows.back()[0]) > failure_s) rows.pop_back();
  }
  return rows;
}

Rows last_rows(const Rows& rows) {
  Rows last;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i][0] == rows.back()[0]) last.push_back(rows[i]);
  }
  return last;
}

double number_in(const std::string& cell) {
  return cell.empty() ? std::nan("") : std::stod(cell);
}

std::string words_of_flow(const std::string& column) {
  std::string text = column.substr(0, column.find("_m2_per_s"));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

}  // namespace blockweir::picture
