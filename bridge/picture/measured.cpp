// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/measured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "bridge/results/counted.hpp"
#include "bridge/results/csv.hpp"
#include "bridge/results/parse_number.hpp"

namespace blockweir::picture {
namespace {

/// Takes lines one after the other, and throws at the first fault.
class Table {
 public:
  explicit Table(std::filesystem::path file) : file_(std::move(file)) {}

  void heading(const std::string& text) {
    names_ = results::csv_cells(text);
    columns_.resize(names_.size());
    if (names_.size() < 2) {
      refuse(1, fmt::format("one column, \"{}\"", names_.front()),
             "time_s and columns as in history.csv, with commas between");
    }
    for (auto name = names_.begin(); name != names_.end(); ++name) {
      if (std::find(names_.begin(), name, *name) != name) refuse(1, fmt::format("two columns \"{}\"", *name), "one");
    }
  }
  void row(int line, const std::string& text) {
    const std::vector<std::string> cells = results::csv_cells(text);
    if (cells.size() != names_.size()) {
      refuse(line, fmt::format("{} in a row", results::counted(cells.size(), "cell")),
             fmt::format("{} as in the heading, with commas between and decimal points", names_.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::optional<double> value = results::parse_number<double>(boost::trim_copy(cells[i]));
      if (!value) {
        refuse(line, fmt::format("\"{}\" in the column \"{}\"", cells[i], names_[i]),
               "a finite number; leave out rows that were not measured");
      }
      columns_[i].push_back(*value);
    }
  }
  /// `last_line`: of the file.
  History history(int last_line) {
    if (columns_.front().empty()) refuse(last_line, "a heading without rows", "a row for each time that was measured");
    return {std::move(names_), std::move(columns_)};
  }

 private:
  [[noreturn]] void refuse(int line, const std::string& found, const std::string& expected) const {
    throw std::invalid_argument(
        fmt::format("--data {}:{}: found {}; expected {}", file_.string(), line, found, expected));
  }

  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace

History read_measured(const std::filesystem::path& file) {
  Table table(file);
  std::ifstream stream(file);
  int line = 0;
  for (std::string text; std::getline(stream, text);) {
    constexpr const char* byte_order_mark = "\xEF\xBB\xBF";  // as spreadsheets begin a text in UTF-8
    if (++line == 1 && text.starts_with(byte_order_mark)) text.erase(0, 3);
    if (text.ends_with('\r')) text.pop_back();
    if (line == 1) {
      table.heading(text);
    } else if (!text.empty()) {
      table.row(line, text);
    }
  }
  return table.history(line);
}

}  // namespace blockweir::picture
