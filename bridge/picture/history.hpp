// SPDX-License-Identifier: GPL-3.0-or-later
// history.csv of a run, read into memory.
#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

namespace blockweir::picture {

class History {
 public:
  /// Throws std::invalid_argument if the file is missing or empty. An incomplete last row is left out.
  explicit History(const std::filesystem::path& file);
  /// Columns of equal length and their names.
  History(std::vector<std::string> names, std::vector<std::vector<double>> columns);

  [[nodiscard]] std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().size(); }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Throws std::out_of_range if there is none.
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const;
  /// Whether the column exists and contains a number. Levels of a scene without water contain none.
  [[nodiscard]] bool has_values(const std::string& name) const;
  /// Blocks or joints NAME, sorted by the largest size of the columns NAME.first and NAME.second, largest first.
  [[nodiscard]] std::vector<std::string> largest_first(const std::string& first, const std::string& second) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
  std::unordered_map<std::string, std::size_t> index_;
};

}  // namespace blockweir::picture
