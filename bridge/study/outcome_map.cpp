// SPDX-License-Identifier: GPL-3.0-or-later
// kind = "map": the outcome over two keys.
#include <fmt/format.h>

#include "bridge/study/map_figure.hpp"
#include "bridge/study/open_study.hpp"

namespace blockweir::study {
namespace {

using nlohmann::json;

Finding draw_map(const scene::OutcomeMap& map, OutcomeRuns& runs) {
  const auto& [x, y] = map.axes;
  std::vector<Settings> cells;
  // Rows from the last value down, as a map has its north on top.
  for (auto row = y.values.rbegin(); row != y.values.rend(); ++row) {
    for (const std::string& column : x.values) cells.push_back({x.key + "=" + column, y.key + "=" + *row});
  }
  Finding finding{.answer = {{"outcomes", json::object()}}, .runs = runs.make(cells)};
  json shown = json::array();
  for (const Outcome& run : finding.runs) {
    const std::string word = shown_word(run);
    shown.push_back({{"shown", word}, {"verdict", run.contains("trouble") ? "none" : "right"}});
    finding.answer["outcomes"][word] = finding.answer["outcomes"].value(word, 0) + 1;
  }
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const std::size_t column = i % x.values.size();
    if (column == 0) finding.text += fmt::format("  {:>12} ", y.values[y.values.size() - 1 - i / x.values.size()]);
    finding.text += fmt::format(" {} {}", letter(shown[i]["shown"]), column + 1 == x.values.size() ? "\n" : "");
  }
  finding.text += fmt::format("  {} rightwards from {} to {}\n  {} upwards\n{}", x.key, x.values.front(),
                              x.values.back(), y.key, legend(shown));
  finding.figure = map_figure(map.axes, shown);
  return finding;
}

}  // namespace

OpenStudyTask outcome_map_task(const scene::OpenStudy& study) {
  const auto map = std::get<scene::OutcomeMap>(study.question);
  const auto& [x, y] = map.axes;
  OpenStudyTask task{.name = study.name, .kind = "map", .line = study.line, .set = study.set, .keys = {x.key, y.key}};
  for (const std::string& column : x.values) {
    for (const std::string& row : y.values) task.extremes.push_back({x.key + "=" + column, y.key + "=" + row});
  }
  task.find = [map](OutcomeRuns& runs) { return draw_map(map, runs); };
  return task;
}

}  // namespace blockweir::study
