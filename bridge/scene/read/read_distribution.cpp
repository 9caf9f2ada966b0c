// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/read_distribution.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace blockweir::scene {
namespace {

using WordList = std::vector<std::string>;

/// The keys that say how wide each distribution is; all are required.
const std::map<std::string, WordList>& distributions() {
  static const std::map<std::string, WordList> known{{"normal", {"mean", "deviation"}},
                                                     {"lognormal", {"mean", "deviation"}},
                                                     {"uniform", {"from", "to"}},
                                                     {"triangular", {"from", "peak", "to"}},
                                                     {"table", {"table"}},
                                                     {"fitted", {"values"}}};
  return known;
}

void refuse_keys_of_others(TableReader& table, Reading& reading, const std::string& distribution) {
  const WordList& own = distributions().at(distribution);
  for (const std::string& key : keys_of_distributions()) {
    if (key == "least" || key == "most" || !table.has(key.c_str()) ||
        std::find(own.begin(), own.end(), key) != own.end())
      continue;
    reading.problems.error(table.place(key.c_str()),
                           fmt::format("{} in {}, whose distribution is \"{}\"", key, table.name(), distribution),
                           fmt::format("{}", fmt::join(own, " and ")), fmt::format("leave {} out", key));
  }
}

/// Rows [value, probability of less], both rising, from probability 0 to 1.
void read_table(TableReader& table, Reading& reading, Distribution& found, bool wanted) {
  std::vector<Point> rows;
  if (!wanted || !table.has("table")) {
    table.know("table");
    if (wanted) table.points("table", rows, 2);
    return;
  }
  table.points("table", rows, 2);
  const auto falls = [](const Point& a, const Point& b) { return b.x() <= a.x() || b.y() < a.y(); };
  const bool sound = rows.size() >= 2 && std::adjacent_find(rows.begin(), rows.end(), falls) == rows.end() &&
                     rows.front().y() == 0 && rows.back().y() == 1;
  for (const Point& row : rows) found.table.emplace_back(row.x(), row.y());
  if (sound || rows.empty()) return;
  reading.problems.error(table.place("table"), fmt::format("the table of {} is no distribution", table.name()),
                         "rows [value, probability of less than it], both rising, the first with 0, the last with 1",
                         "correct the rows, as in table = [[20, 0], [30, 0.5], [35, 1]]");
}

void read_interval(TableReader& table, Reading& reading, Distribution& found, bool uniform, bool triangular) {
  const bool wanted = uniform || triangular;
  const bool begins = table.number("from", found.from, any_number(), wanted);
  const bool ends = table.number("to", found.to, any_number(), wanted);
  const bool peaks = table.number("peak", found.peak, any_number(), triangular);
  if (!wanted || !begins || !ends) return;
  if (found.from > found.to) {
    reading.problems.error(table.place("to"), fmt::format("{} goes from {} to {}", table.name(), found.from, found.to),
                           "from below to", "exchange the two");
  } else if (found.from == found.to) {
    reading.problems.error(table.place("to"), fmt::format("{} goes from {} to {}", table.name(), found.from, found.to),
                           "from below to: a distribution without width is a number",
                           "widen the distribution, or set the key itself to a number");
  } else if (triangular && peaks && (found.peak < found.from || found.peak > found.to)) {
    reading.problems.error(table.place("peak"), fmt::format("peak in {} is {}", table.name(), found.peak),
                           fmt::format("a value from {} to {}", found.from, found.to), "move it");
  }
}

void read_moments(TableReader& table, Reading& reading, Distribution& found, bool normal, bool lognormal) {
  const bool wanted = normal || lognormal;
  const Range stated{[](double) { return true; }, "a standard deviation above 0"};
  table.number("mean", found.mean, lognormal ? positive() : any_number(), wanted);
  if (table.number("deviation", found.deviation, stated, wanted) && found.deviation <= 0) {
    reading.problems.error(table.place("deviation"),
                           fmt::format("deviation in {} is {}", table.name(), found.deviation),
                           "a standard deviation above 0: a distribution without width is a number",
                           "widen the distribution, or set the key itself to a number");
  }
}

void read_values(TableReader& table, Reading& reading, Distribution& found, bool wanted) {
  constexpr std::size_t fewest = 5;
  if (!wanted) return table.know("values");
  if (!table.numbers("values", found.values, any_number(), fewest)) return;
  const auto [least, most] = std::minmax_element(found.values.begin(), found.values.end());
  if (*least < *most) return;
  reading.problems.error(table.place("values"), fmt::format("all values of {} are {}", table.name(), *least),
                         "values that differ: a distribution without width is a number",
                         "set the key itself to a number");
}

void read_cuts(TableReader& table, Reading& reading, Distribution& found) {
  table.number("least", found.least);
  table.number("most", found.most);
  if (!found.least || !found.most || *found.least < *found.most) return;
  reading.problems.error(
      table.place("most"),
      fmt::format("{} is cut off at least = {} and most = {}", table.name(), *found.least, *found.most),
      "least below most", "move one of them, or leave it out");
}

}  // namespace

const std::vector<std::string>& keys_of_distributions() {
  static const WordList keys{"mean", "deviation", "from", "peak", "to", "table", "values", "least", "most"};
  return keys;
}

std::optional<Distribution> read_distribution(TableReader& table, Reading& reading, bool required) {
  Distribution found;
  WordList words;
  for (const auto& [word, keys] : distributions()) words.push_back(word);
  const bool known = table.word("distribution", found.kind, words, required);
  const auto is = [&](const char* word) { return known && found.kind == word; };
  read_moments(table, reading, found, is("normal"), is("lognormal"));
  read_interval(table, reading, found, is("uniform"), is("triangular"));
  read_table(table, reading, found, is("table"));
  read_values(table, reading, found, is("fitted"));
  read_cuts(table, reading, found);
  if (!known) return std::nullopt;
  refuse_keys_of_others(table, reading, found.kind);
  return found;
}

}  // namespace blockweir::scene
