// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/validate/compared_run.hpp"

#include <fmt/format.h>

#include "bridge/study/study.hpp"
#include "bridge/validate/table_line.hpp"

namespace blockweir::study {

using nlohmann::json;
using process::RunOptions;
using process::RunResult;

RunResult uninterrupted(const std::string& what, RunOptions options) {
  fmt::print(stderr, "{}\n", what);
  options.quiet = options.tells_progress = true;
  RunResult result = run(options);
  if (result.exit_code == 130) throw Interrupted();
  return result;
}

/// What makes the run again, on a command line.
std::string command_of(const RunOptions& options) {
  std::string text = fmt::format("blockweir run {}", options.scene.string());
  if (!options.variant.empty()) text += fmt::format(" --variant '{}'", options.variant);
  for (const std::string& set : options.overrides) text += fmt::format(" --set '{}'", set);
  return text;
}

/// Figures to compare: those that the scene states, or, if it states none, the outcome of the run.
json figures(const json& s) {
  if (!s["checks"].empty()) return s["checks"];
  const auto figure_of = [](const char* name, const json& got) {
    return json{{"name", name}, {"expected", nullptr}, {"got", got}, {"relative_error", nullptr}};
  };
  json list = {figure_of("outcome", outcome_word(s)), figure_of("largest_displacement_m", s["largest_displacement_m"])};
  if (s.contains("failure")) {
    for (const char* name : {"level_m", "time_s"}) {
      if (s["failure"][name].is_null()) continue;  // without water
      list.push_back(figure_of(fmt::format("failure_{}", name).c_str(), s["failure"][name]));
    }
  } else if (s.contains("margin") && s["margin"].contains("sliding_factor")) {
    list.push_back(figure_of("sliding_factor", s["margin"]["sliding_factor"]));
  }
  return list;
}

void print_figure(const std::string& name, const std::string& got, const std::string& error) {
  fmt::print("{}", table_line("    " + name, fmt::format("{:>16} {:>9}", got, error)));
}

}  // namespace blockweir::study
