// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/read_randomness.hpp"
#include "bridge/scene/read/overrides.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/read_distribution.hpp"

namespace blockweir::scene {
namespace {

using WordList = std::vector<std::string>;

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
  if (const auto distribution = read_distribution(table, reading, true)) variable.distribution = *distribution;
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
    if (i >= size || j >= size || i == j) return;  // reported elsewhere
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

/// The level is the unknown. A filling may depend on random numbers, but must not be random itself.
void refuse_random_level(Reading& reading, const Randomness& random) {
  const std::string level = "water.upstream_level_m";
  const bool runs = random.reliability.by == CapacityBy::runs;
  for (const RandomVariable& variable : random.variables) {
    WordList keys = runs ? WordList{} : variable.set;
    for (std::string& key : keys) key = setting_key(key);
    keys.push_back(variable.key);
    if (std::none_of(keys.begin(), keys.end(),
                     [&](const std::string& key) { return key == level || (!runs && key.starts_with(level + ".")); }))
      continue;
    reading.problems.error(
        reading.problems.at(variable.line), fmt::format("[[random]] \"{}\" sets {}", variable.name, level),
        "numbers that the level of failure depends on: that level is looked for, so that the one stated has no effect",
        "leave it out: the fragility curve has the probability of failure at each level, to be weighed with the "
        "level's own distribution");
  }
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

void read_methods(TableReader& table, Reading& reading, Randomness& random) {
  Reliability& reliability = random.reliability;
  const WordList known{"form", "sorm", "importance", "subset", "sobol", "none"};
  WordList methods;
  if (!table.texts_if_any("methods", methods)) {
    if (reliability.by == CapacityBy::runs) reliability.methods.clear();
    if (!random.correlations.empty()) std::erase(reliability.methods, "sobol");  // has none of correlated variables
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
  read_methods(table, reading, random);
  refuse_random_level(reading, random);
  const toml::table* stated = reading.file["reliability"].as_table();
  if (stated != nullptr && !stated->empty() && random.variables.empty()) {
    reading.problems.error(table.place(), "[reliability] and no [[random]]", "what is uncertain, as a [[random]] each",
                           "add [[random]] with key and distribution, or leave [reliability] out");
  }
  return random;
}

}  // namespace blockweir::scene
