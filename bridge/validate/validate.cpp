// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/validate/validate.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "bridge/process/run.hpp"
#include "bridge/results/counted.hpp"
#include "bridge/results/figure.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/check_work.hpp"
#include "bridge/study/engines.hpp"
#include "bridge/study/study.hpp"
#include "bridge/validate/cases_folder.hpp"
#include "bridge/validate/table_line.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using process::RunOptions;
using results::figure;

/// One run of a case: as it is, or one of its variants, with a point of the sweep.
struct Trial {
  std::string label;  ///< for the table
  RunOptions run;
};

std::vector<Trial> trials(const fs::path& path, const ValidateOptions& options) {
  std::vector<Trial> all;
  std::vector<std::string> variants{""};
  for (const auto& variant : scene::read(path).scene.variants) variants.push_back(variant.name);
  for (const std::string& variant : variants) {
    Trial trial{case_name(path) + (variant.empty() ? "" : ", " + variant),
                {.scene = path, .variant = variant, .overrides = options.overrides, .quiet = true}};
    if (!options.sweep) {
      all.push_back(trial);
      continue;
    }
    for (const char* penalty : {"5e6", "1e9", "1e12"}) {
      for (const char* step : {"1e-2", "1e-3"}) {
        Trial& point = all.emplace_back(trial);
        point.label += fmt::format(" p={} dt={}", penalty, step);
        point.run.overrides.push_back(fmt::format("contact.initial_penalty_n_per_m2={}", penalty));
        point.run.overrides.push_back(fmt::format("analysis.step_s={}", step));
      }
    }
  }
  return all;
}

/// The table, printed case by case and kept for --json.
class Table {
 public:
  Table() { print_row("case, quantity", "expected", "got", "error", "tolerance", ""); }
  /// A figure of `label`; `sound`: whether its run went to its end.
  void add(const std::string& label, json check, double wall_time_s, bool sound) {
    const bool passed = sound && check["passed"].get<bool>();
    all_passed_ = all_passed_ && passed;
    begin(label, fmt::format("{:.3g} s", wall_time_s));
    const json& error = check["relative_error"];
    print_row("  " + check["name"].get<std::string>(), figure(check["expected"]), figure(check["got"]),
              error.is_number() ? fmt::format("{:.2e}", error.get<double>()) : "none", figure(check["tolerance"]),
              passed ? "" : "OUT");
    check["case"] = label;
    check["wall_time_s"] = wall_time_s;
    rows_.push_back(std::move(check));
  }
  void trouble(const std::string& label, const std::string& text) {
    all_passed_ = false;
    begin(label, "");
    fmt::print("{}", results::wrapped("  " + text));
  }
  [[nodiscard]] const json& rows() const { return rows_; }
  [[nodiscard]] bool all_passed() const { return all_passed_; }

 private:
  /// Once for all figures of a run.
  void begin(const std::string& label, const std::string& time) {
    if (std::exchange(label_, label) != label) fmt::print("{}", table_line(label, time));
  }
  static void print_row(const std::string& name, const std::string& expected, const std::string& got,
                        const std::string& error, const std::string& tolerance, const char* verdict) {
    const std::string cells = fmt::format("{:>12} {:>12} {:>8} {:>9}", expected, got, error, tolerance);
    fmt::print("{}", *verdict == '\0' ? table_line(name, cells, 76) : table_line(name, cells + " " + verdict, 80));
    std::fflush(stdout);
  }

  std::string label_;  ///< of the last row
  json rows_ = json::array();
  bool all_passed_ = true;
};

void add_run(Table& table, const std::string& label, const json& answer) {
  if (!answer.is_object()) return table.trouble(label, "its process was killed; see whether memory is short");
  const std::string trouble = answer["trouble"];
  if (!trouble.empty()) table.trouble(label, trouble);
  for (const json& check : answer["checks"]) {
    table.add(label, check, answer["wall_time_s"].get<double>(), trouble.empty());
  }
}

void add_study(Table& table, const std::string& label, const json& answer) {
  const StudyResult result = study_result(answer);
  if (result.check.contains("trouble")) return table.trouble(label, result.check["trouble"].get<std::string>());
  table.add(label, result.check, result.check["wall_time_s"].get<double>(), true);
}

}  // namespace

int validate(const ValidateOptions& options) {
  engine::Work work{.name = "validate", .common = {{"by", "check"}}, .items = {}};
  std::vector<std::string> labels;
  for (const fs::path& path : options.cases.empty() ? all_cases() : options.cases) {  // a wrong scene is found first
    for (const Trial& trial : trials(path, options)) {
      work.items.push_back(run_item(path, trial.run.variant, trial.run.overrides));
      labels.push_back(trial.label);
    }
    if (options.sweep) continue;
    for (const StudyTask& task : study_tasks(path, options.overrides)) {
      work.items.push_back(study_item(path, task.name, options.overrides, options.brief, /*reported=*/false));
      labels.push_back(fmt::format("{}, {}", case_name(path), task.name));
    }
  }
  if (!options.json.empty()) results::require_writable_file("--json", options.json, {".json"});
  const auto engine = make_engine(options.engine, "runs/validate");
  Table table;
  try {
    perform_in_order(*engine, work, [&](std::size_t i, const json& answer) {
      work.items[i].contains("study") ? add_study(table, labels[i], answer) : add_run(table, labels[i], answer);
    });
  } catch (const Interrupted&) {
    return 130;
  }
  if (table.rows().empty()) {
    fmt::print(
        "no scene states a figure: add [[expect]] with a quantity and its value; \"blockweir run\" and \"blockweir "
        "compare\" need none\n");
    return 1;
  }
  if (!options.json.empty()) results::replace_file(options.json, table.rows().dump(2) + "\n");
  fmt::print("{}, {}\n", results::counted(table.rows().size(), "figure"),
             table.all_passed() ? "all within tolerance" : "NOT all within tolerance");
  return table.all_passed() ? 0 : 1;
}

}  // namespace blockweir::study
