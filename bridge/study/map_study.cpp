// SPDX-License-Identifier: GPL-3.0-or-later
// [[map]]: a quantity over two keys, each cell right, refused with a reason, or wrong.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bridge/results/counted.hpp"
#include "bridge/study/map_figure.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {
namespace {

using nlohmann::json;

/// As TOML has it, or else a word.
json value_of(const std::string& text) {
  const json number = json::parse(text, nullptr, /*allow_exceptions=*/false);
  return number.is_discarded() ? json(text) : number;
}

/// A crash, a hang and a figure that is off are wrong; a program that ends by itself and says why is not.
json judged(const Attempt& attempt) {
  json cell = {{"wall_time_s", attempt.wall_time_s}};
  if (!attempt.trouble.empty()) {
    cell["verdict"] = attempt.refused ? "refused" : "wrong";
    cell["reason"] = attempt.trouble;
    cell["shown"] = cell["verdict"];
    return cell;
  }
  const json& check = attempt.summary["checks"][0];
  const bool right = check["passed"].get<bool>();
  cell["verdict"] = right ? "right" : "wrong";
  cell["expected"] = check["expected"];
  cell["got"] = check["got"];
  cell["error"] = check["relative_error"];
  cell["shown"] = check["got"].is_string() ? check["got"] : cell["verdict"];
  cell["iterations"] = attempt.summary["counts"]["iterations"];
  return cell;
}

/// From the least to the largest of what the cells of a row took.
std::string work(const std::vector<json>& cells) {
  const auto range = [&](const char* key, const char* format) -> std::string {
    std::vector<double> values;
    for (const json& cell : cells) {
      if (cell.contains("iterations")) values.push_back(cell[key]);
    }
    if (values.empty()) return "none";
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return fmt::format(fmt::runtime(format), *least, *most);
  };
  return fmt::format("{} iterations, {} s", range("iterations", "{:.0f} to {:.0f}"),
                     range("wall_time_s", "{:.2g} to {:.2g}"));
}

std::string difference(const json& cell, bool by_formula) {
  if (cell.contains("reason")) return cell["reason"];
  const auto shown = [](const json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); };
  return fmt::format("{}, {} {}{}", shown(cell["got"]), by_formula ? "but" : "expected", shown(cell["expected"]),
                     by_formula ? " by the formula" : "");
}

StudyResult draw_map(const scene::MapStudy& study, StudyRuns& runs) {
  StudyResult result;
  const auto& [x, y] = study.axes;
  std::string differences;
  // Rows from the last value down, as a map has its north on top.
  for (auto row = y.values.rbegin(); row != y.values.rend(); ++row) {
    result.text += fmt::format("  {:>12} ", *row);
    std::vector<json> cells;
    for (const std::string& column : x.values) {
      const Settings settings{x.key + "=" + column, y.key + "=" + *row};
      json cell = judged(runs.attempt(settings, study.expected, study.longest_s));
      cell["x"] = value_of(column);
      cell["y"] = value_of(*row);
      const std::string verdict = cell["verdict"];
      result.text += fmt::format(" {}{}", letter(cell["shown"]), verdict == "wrong" ? wrong_mark : ' ');
      if (verdict != "right")
        differences += fmt::format("  {}: {}, {}: {}\n", verdict, settings[0], settings[1],
                                   difference(cell, !study.expected.formula.empty()));
      cells.push_back(std::move(cell));
    }
    result.text += "   " + work(cells) + "\n";
    for (json& cell : cells) result.runs.push_back(std::move(cell));
  }
  result.text +=
      fmt::format("  {} rightwards from {} to {}; {} upwards\n", x.key, x.values.front(), x.values.back(), y.key);
  result.text += legend(result.runs) + differences;

  const auto count = [&](const char* verdict) {
    return std::count_if(result.runs.begin(), result.runs.end(),
                         [&](const json& c) { return c["verdict"] == verdict; });
  };
  const auto cells = static_cast<long>(result.runs.size());
  const long right = count("right");
  const long refused = count("refused");
  const long too_many = std::max(0L, refused - study.may_refuse);
  const long wrong = right == 0 ? cells : count("wrong") + too_many;  // a map without a right cell shows nothing
  result.check = {{"name", "wrong of " + results::counted(static_cast<std::size_t>(cells), "cell")},
                  {"expected", 0},
                  {"got", wrong},
                  {"relative_error", static_cast<double>(wrong)},
                  {"tolerance", 0.0},
                  {"passed", wrong == 0},
                  {"right", right},
                  {"refused", refused},
                  {"formula", study.expected.formula},
                  {"source", study.expected.source}};
  result.figure = map_figure(study.axes, result.runs);
  return result;
}

}  // namespace

StudyTask map_task(const scene::MapStudy& study) {
  StudyTask task{.name = study.name, .kind = "[[map]]", .line = study.line, .set = study.set};
  const auto& [x, y] = study.axes;
  for (const std::string& column : x.values) {
    if (study.may_refuse > 0) break;  // a scene that is not sound is a way to refuse
    for (const std::string& row : y.values) task.extremes.push_back({x.key + "=" + column, y.key + "=" + row});
  }
  task.go = [study](StudyRuns& runs) { return draw_map(study, runs); };
  return task;
}

}  // namespace blockweir::study
