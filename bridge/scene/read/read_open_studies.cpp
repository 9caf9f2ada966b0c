// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/read_open_studies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "bridge/scene/read/read_distribution.hpp"
#include "bridge/scene/read/unique_file_names.hpp"

namespace blockweir::scene {
namespace {

using KeyNames = std::vector<const char*>;

/// Reports keys that only another kind of the table reads.
void refuse_keys_of_others(TableReader& table, Reading& reading, const std::string& kind, const KeyNames& own,
                           const KeyNames& all) {
  for (const char* key : all) {
    const bool is_own = std::any_of(own.begin(), own.end(), [&](const char* k) { return std::string(k) == key; });
    if (is_own || !table.has(key)) continue;
    reading.problems.error(table.place(key), fmt::format("{} in {}, which is a {}", key, table.name(), kind),
                           fmt::format("one of {}", fmt::join(own, ", ")), fmt::format("leave {} out", key));
  }
}

CriticalValue read_critical(TableReader& table, Reading& reading, bool wanted) {
  CriticalValue critical;
  table.text("key", critical.key, wanted);
  table.text("outcome", critical.outcome);
  table.number("width", critical.width, positive());
  const bool of_factor = critical.outcome == "factor";
  const bool has_target = table.number("target", critical.target, positive());
  if (wanted && of_factor && !has_target && !table.has("target")) {
    reading.problems.error(table.place("outcome"), fmt::format("{} has no target", table.name()),
                           "the factor of safety that is to be reached", "add target = 1.5, say");
  }
  if (wanted && critical.target && !of_factor) {
    reading.problems.error(table.place("target"),
                           fmt::format("target in {}, whose outcome is \"{}\"", table.name(), critical.outcome),
                           "outcome = \"factor\" beside target", "add it, or leave target out");
  }
  const bool begins = table.number("from", critical.from, any_number(), wanted);
  const bool ends = table.number("to", critical.to, any_number(), wanted);
  if (wanted && begins && ends && critical.from == critical.to) {
    reading.problems.error(table.place("to"),
                           fmt::format("{} goes from {} to {}", table.name(), critical.from, critical.to),
                           "two values that differ", "move one of them");
  }
  return critical;
}

OutcomeMap read_outcome_map(TableReader& table, bool wanted) {
  OutcomeMap map;
  for (const auto& [axis, key, values] : {std::tuple{0U, "x_key", "x_values"}, {1U, "y_key", "y_values"}}) {
    table.text(key, map.axes[axis].key, wanted);
    if (wanted || table.has(values))
      table.settings(values, map.axes[axis].values);
    else
      table.know(values);
  }
  return map;
}

Variable read_variable(TableReader& table, Reading& reading, const Sample& sample) {
  Variable variable;
  table.text("key", variable.key, true);
  table.text("column", variable.column);
  variable.distribution = read_distribution(table, reading, false);
  if (table.has("distribution")) {
    if (!table.has("column")) return variable;
    reading.problems.error(table.place("column"), fmt::format("column in {}, which has a distribution", table.name()),
                           "a distribution, or a column of the study's file", "leave one of them out");
  } else if (sample.file.empty()) {
    reading.problems.error(table.place(), fmt::format("{} has no distribution", table.name()),
                           "a distribution, or a file of the study with a column for it",
                           "add distribution = \"normal\", mean = ... and deviation = ..., or file = \"FILE.csv\"");
  } else {
    KeyNames others;
    for (const std::string& key : keys_of_distributions()) others.push_back(key.c_str());
    refuse_keys_of_others(table, reading, "column of the study's file", {"key", "column"}, others);
    if (variable.column.empty()) variable.column = variable.key;
  }
  return variable;
}

Sample read_sample(TableReader& table, Reading& reading, bool wanted) {
  Sample sample;
  table.text("file", sample.file);
  const bool counted = table.integer("runs", sample.runs, 1);
  table.integer("seed", sample.seed, 0);
  if (wanted && !counted && sample.file.empty()) {
    reading.problems.error(table.place(), fmt::format("{} has neither runs nor a file", table.name()),
                           "the number of runs, or a file with a row for each", "add runs = ...");
  }
  const auto variables = table.tables("variable", wanted);
  for (std::size_t i = 0; wanted && i < variables.size(); ++i) {
    TableReader one(reading.problems, variables[i], fmt::format("variable {} of {}", i + 1, table.name()));
    sample.variables.push_back(read_variable(one, reading, sample));
  }
  return sample;
}

OpenStudy read_open_study(TableReader& table, Reading& reading) {
  static const std::map<std::string, KeyNames> kinds{{"critical", {"key", "from", "to", "width", "outcome", "target"}},
                                                     {"map", {"x_key", "x_values", "y_key", "y_values"}},
                                                     {"sample", {"runs", "seed", "file", "variable"}}};
  OpenStudy study{.line = table.place().line};
  table.text("name", study.name, true);
  table.texts_if_any("set", study.set);
  std::string kind;
  const bool known = table.word("kind", kind, {"critical", "map", "sample"}, true);
  const CriticalValue critical = read_critical(table, reading, kind == "critical");
  const OutcomeMap map = read_outcome_map(table, kind == "map");
  const Sample sample = read_sample(table, reading, kind == "sample");
  std::vector<std::string> own_keys{critical.key, map.axes[0].key, map.axes[1].key};
  for (const Variable& variable : sample.variables) own_keys.push_back(variable.key);
  check_settings(table, reading, study.set, own_keys);
  if (kind == "critical") study.question = critical;
  if (kind == "map") study.question = map;
  if (kind == "sample") study.question = sample;
  KeyNames all;
  for (const auto& [name, keys] : kinds) all.insert(all.end(), keys.begin(), keys.end());
  if (known) refuse_keys_of_others(table, reading, kind + " study", kinds.at(kind), all);
  return study;
}

}  // namespace

std::vector<OpenStudy> read_open_studies(Reading& reading) {
  UniqueFileNames files("study");
  files.reserve("orders");
  const Studies& others = reading.scene.studies;
  for (const auto& study : others.limits) files.take(study.name, study.line);
  for (const auto& study : others.orders) files.take(study.name, study.line);
  for (const auto& study : others.maps) files.take(study.name, study.line);
  for (const auto& bench : others.benches) files.take(bench.name, bench.line);
  std::vector<OpenStudy> all;
  reading.each("study", [&](TableReader& table) {
    OpenStudy study = read_open_study(table, reading);
    files.add(reading, table, study.name);
    all.push_back(std::move(study));
  });
  return all;
}

}  // namespace blockweir::scene
