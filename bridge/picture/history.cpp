// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "bridge/results/csv.hpp"

namespace blockweir::picture {

History::History(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line)) {
    throw std::invalid_argument(
        fmt::format("{}: found no such file, an empty one, or one that you may not read; expected the folder of a run "
                    "that has begun; name that folder",
                    file.string()));
  }
  names_ = results::csv_cells(line);
  for (std::size_t i = 0; i < names_.size(); ++i) index_.emplace(names_[i], i);
  columns_.resize(names_.size());
  while (std::getline(stream, line)) {
    if (std::count(line.begin(), line.end(), ',') + 1 != static_cast<std::ptrdiff_t>(names_.size())) break;
    const char* at = line.c_str();
    for (auto& column : columns_) {
      char* end = nullptr;
      column.push_back(std::strtod(at, &end));
      at = end + 1;
    }
  }
}

History::History(std::vector<std::string> names, std::vector<std::vector<double>> columns)
    : names_(std::move(names)), columns_(std::move(columns)) {
  for (std::size_t i = 0; i < names_.size(); ++i) index_.emplace(names_[i], i);
}

const std::vector<double>& History::column(const std::string& name) const {
  return columns_[index_.at(name)];
}

bool History::has_values(const std::string& name) const {
  const auto found = index_.find(name);
  if (found == index_.end()) return false;
  const auto& values = columns_[found->second];
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

std::vector<std::string> History::largest_first(const std::string& first, const std::string& second) const {
  std::vector<std::pair<double, std::string>> reaches;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!names_[i].ends_with("." + first)) continue;
    const std::string name = names_[i].substr(0, names_[i].size() - first.size() - 1);
    double reach = 0;
    for (const auto& quantity : {first, second}) {
      const auto found = index_.find(name + "." + quantity);
      if (found == index_.end()) continue;
      for (const double value : columns_[found->second]) reach = std::max(reach, std::abs(value));
    }
    if (reach > 0) reaches.emplace_back(reach, name);
  }
  std::stable_sort(reaches.begin(), reaches.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> names;
  for (const auto& [reach, name] : reaches) names.push_back(name);
  return names;
}

}  // namespace blockweir::picture
