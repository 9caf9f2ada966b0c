// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/read_randomness.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "bridge/scene/read/nearest.hpp"

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
  for (const char* key : {"mean", "deviation", "from", "peak", "to", "table", "values"}) {
    if (!table.has(key) || std::find(own.begin(), own.end(), key) != own.end()) continue;
    reading.problems.error(table.place(key),
                           fmt::format("{} in {}, whose distribution is \"{}\"", key, table.name(), distribution),
                           fmt::format("{}", fmt::join(own, " and ")), fmt::format("leave {} out", key));
  }
}

/// Rows [value, probability of less], both rising, from probability 0 to 1.
void read_table(TableReader& table, Reading& reading, RandomVariable& variable, bool wanted) {
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
  for (const Point& row : rows) variable.table.emplace_back(row.x(), row.y());
  if (sound || rows.empty()) return;
  reading.problems.error(table.place("table"), fmt::format("the table of {} is no distribution", table.name()),
                         "rows [value, probability of less than it], both rising, the first with 0, the last with 1",
                         "correct the rows, as in table = [[20, 0], [30, 0.5], [35, 1]]");
}

void read_interval(TableReader& table, Reading& reading, RandomVariable& variable, bool uniform, bool triangular) {
  const bool wanted = uniform || triangular;
  const bool begins = table.number("from", variable.from, any_number(), wanted);
  const bool ends = table.number("to", variable.to, any_number(), wanted);
  const bool peaks = table.number("peak", variable.peak, any_number(), triangular);
  if (!wanted || !begins || !ends) return;
  if (variable.from >= variable.to) {
    reading.problems.error(table.place("to"),
                           fmt::format("{} goes from {} to {}", table.name(), variable.from, variable.to),
                           "from below to: a distribution without width is a number",
                           "widen it, or set the key itself and leave the [[random]] out");
  } else if (triangular && peaks && (variable.peak < variable.from || variable.peak > variable.to)) {
    reading.problems.error(table.place("peak"), fmt::format("peak in {} is {}", table.name(), variable.peak),
                           fmt::format("a value from {} to {}", variable.from, variable.to), "move it");
  }
}

void read_moments(TableReader& table, Reading& reading, RandomVariable& variable, bool normal, bool lognormal) {
  const bool wanted = normal || lognormal;
  table.number("mean", variable.mean, lognormal ? positive() : any_number(), wanted);
  if (table.number("deviation", variable.deviation, not_negative(), wanted) && variable.deviation == 0) {
    reading.problems.error(table.place("deviation"), fmt::format("deviation in {} is 0", table.name()),
                           "a standard deviation above 0: a distribution without width is a number",
                           "widen it, or set the key itself and leave the [[random]] out");
  }
}

void read_values(TableReader& table, Reading& reading, RandomVariable& variable, bool wanted) {
  constexpr std::size_t fewest = 5;
  if (!wanted) return table.know("values");
  if (!table.numbers("values", variable.values, any_number(), fewest)) return;
  const auto [least, most] = std::minmax_element(variable.values.begin(), variable.values.end());
  if (*least < *most) return;
  reading.problems.error(table.place("values"), fmt::format("all values of {} are {}", table.name(), *least),
                         "values that differ: a distribution without width is a number",
                         "set the key itself and leave the [[random]] out");
}

void read_cuts(TableReader& table, Reading& reading, RandomVariable& variable) {
  table.number("least", variable.least);
  table.number("most", variable.most);
  if (!variable.least || !variable.most || *variable.least < *variable.most) return;
  reading.problems.error(
      table.place("most"),
      fmt::format("{} is cut off at least = {} and most = {}", table.name(), *variable.least, *variable.most),
      "least below most", "move one of them, or leave it out");
}

/// Where the number goes: one key, or settings that hold {NAME}.
void read_target(TableReader& table, Reading& reading, RandomVariable& variable) {
  const bool keyed = table.text("key", variable.key);
  const bool sets = table.texts_if_any("set", variable.set);
  if (keyed == sets) {
    reading.problems.error(table.place(),
                           fmt::format("{} has {} key and set", table.name(), keyed ? "both" : "neither"),
                           "the key whose value it is, or settings with its name in braces",
                           "add key = \"joint.friction_angle_deg\", say, or set = [\"key=[[0, 0], [{width}, 0]]\"]");
  }
  if (variable.name.empty()) variable.name = variable.key;
  const std::string mark = "{" + variable.name + "}";
  if (sets && std::none_of(variable.set.begin(), variable.set.end(),
                           [&](const std::string& s) { return s.find(mark) != std::string::npos; })) {
    reading.problems.error(table.place("set"), fmt::format("no setting of {} holds {}", table.name(), mark),
                           "the variable's name in braces where its value goes",
                           fmt::format("write {} in place of the number", mark));
  }
}

RandomVariable read_variable(TableReader& table, Reading& reading) {
  RandomVariable variable{.line = table.place().line};
  table.text("name", variable.name);
  read_target(table, reading, variable);
  WordList words;
  for (const auto& [word, keys] : distributions()) words.push_back(word);
  const bool known = table.word("distribution", variable.distribution, words, true);
  const auto is = [&](const char* word) { return known && variable.distribution == word; };
  read_moments(table, reading, variable, is("normal"), is("lognormal"));
  read_interval(table, reading, variable, is("uniform"), is("triangular"));
  read_table(table, reading, variable, is("table"));
  read_values(table, reading, variable, is("fitted"));
  read_cuts(table, reading, variable);
  if (known) refuse_keys_of_others(table, reading, variable.distribution);
  return variable;
}

Correlation read_correlation(TableReader& table, Reading& reading, const WordList& names) {
  Correlation correlation{.line = table.place().line};
  std::vector<std::string> between;
  if (table.texts("between", between, 2)) std::copy(between.begin(), between.end(), correlation.between.begin());
  for (const std::string& name : between) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    reading.problems.error(table.place("between"), fmt::format("no [[random]] is called \"{}\"", name),
                           names.empty() ? "a [[random]] of that name" : one_of(names), did_you_mean(name, names));
  }
  if (between.size() == 2 && between[0] == between[1]) {
    reading.problems.error(table.place("between"), fmt::format("a correlation of \"{}\" with itself", between[0]),
                           "two variables", "name another one");
  }
  const Range open{[](double v) { return std::abs(v) < 1; }, "a number between -1 and 1"};
  table.number("coefficient", correlation.coefficient, open, true);
  return correlation;
}

/// No three variables can each be against the other two: the matrix has to be positive definite.
void require_positive_definite(Reading& reading, const Randomness& random, const WordList& names) {
  const auto size = static_cast<Eigen::Index>(names.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
  const auto index = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  for (const Correlation& c : random.correlations) {
    const auto i = index(c.between[0]);
    const auto j = index(c.between[1]);
    if (i >= size || j >= size || i == j) return;  // told where it stands
    if (matrix(i, j) != 0) {
      reading.problems.error(reading.problems.at(c.line),
                             fmt::format("a second correlation of \"{}\" and \"{}\"", c.between[0], c.between[1]),
                             "one for each pair of variables", "leave one of them out");
    }
    matrix(i, j) = matrix(j, i) = c.coefficient;
  }
  if (random.correlations.empty()) return;
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().minCoeff();
  if (least > 1e-9) return;
  reading.problems.error(
      reading.problems.at(random.correlations.front().line),
      fmt::format("the correlations contradict each other: their matrix has the eigenvalue {:.3g}", least),
      "a matrix that is positive definite, as that of measured variables is",
      "take coefficients nearer to 0, or all from one set of measurements");
}

Reliability read_reliability(TableReader& table) {
  Reliability reliability;
  table.choice("by", reliability.by,
               {{"limit", CapacityBy::limit}, {"statics", CapacityBy::statics}, {"runs", CapacityBy::runs}});
  table.number("level_m", reliability.level_m);
  table.word("sampling", reliability.sampling, {"monte-carlo", "latin-hypercube", "quasi-random"});
  table.integer("samples", reliability.samples, 10);
  table.integer("seed", reliability.seed, 0);
  table.integer("method_samples", reliability.method_samples, 10);
  return reliability;
}

void read_methods(TableReader& table, Reading& reading, Reliability& reliability) {
  const WordList known{"form", "sorm", "importance", "subset", "sobol", "none"};
  WordList methods;
  if (!table.texts_if_any("methods", methods)) {
    if (reliability.by == CapacityBy::runs) reliability.methods.clear();
    return;
  }
  for (const std::string& method : methods) {
    if (std::find(known.begin(), known.end(), method) != known.end()) continue;
    reading.problems.error(table.place("methods"), fmt::format("{} has the method \"{}\"", table.name(), method),
                           one_of(known), did_you_mean(method, known));
  }
  std::erase(methods, "none");
  if (reliability.by == CapacityBy::runs && !methods.empty()) {
    reading.problems.error(table.place("methods"), fmt::format("the method \"{}\" beside by = \"runs\"", methods[0]),
                           "samples alone: the level of a run is no smooth function of its keys",
                           "leave methods out, or state by = \"limit\" or \"statics\"");
  }
  reliability.methods = std::move(methods);
}

}  // namespace

Randomness read_randomness(Reading& reading) {
  Randomness random;
  WordList names;
  reading.each("random", [&](TableReader& table) {
    RandomVariable variable = read_variable(table, reading);
    const bool again = std::find(names.begin(), names.end(), variable.name) != names.end();
    if (again && !variable.name.empty()) {
      reading.problems.error(table.place(), fmt::format("a second [[random]] is called \"{}\"", variable.name),
                             "a name, or a key, for each", "give it a name of its own");
    }
    names.push_back(variable.name);
    random.variables.push_back(std::move(variable));
  });
  reading.each("correlation",
               [&](TableReader& table) { random.correlations.push_back(read_correlation(table, reading, names)); });
  require_positive_definite(reading, random, names);
  TableReader table(reading.problems, reading.section("reliability"), "[reliability]");
  random.line = table.present() ? table.place().line : 0;
  random.reliability = read_reliability(table);
  read_methods(table, reading, random.reliability);
  const toml::table* stated = reading.file["reliability"].as_table();
  if (stated != nullptr && !stated->empty() && random.variables.empty()) {
    reading.problems.error(table.place(), "[reliability] and no [[random]]", "what is uncertain, as a [[random]] each",
                           "add [[random]] with key and distribution, or leave [reliability] out");
  }
  return random;
}

}  // namespace blockweir::scene
