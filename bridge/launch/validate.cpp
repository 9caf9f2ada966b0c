// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "bridge/launch/run.hpp"

namespace blockweir::launch {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The cases of the source tree, or of an install: both stand at a fixed place from the program.
fs::path cases_folder() {
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  for (const char* place : {"../../../cases", "../share/blockweir/cases"}) {
    if (fs::is_directory(here / place)) return fs::canonical(here / place);
  }
  throw std::invalid_argument("there is no folder of cases beside the program; name the cases to validate");
}

std::vector<fs::path> all_cases() {
  std::vector<fs::path> cases;
  for (const auto& entry : fs::directory_iterator(cases_folder())) {
    if (fs::exists(entry.path() / "scene.toml")) cases.push_back(entry.path());
  }
  std::sort(cases.begin(), cases.end());
  return cases;
}

struct Variant {
  std::string name;
  std::vector<std::string> overrides;
};

std::vector<Variant> variants(const ValidateOptions& options) {
  if (!options.sweep) return {{"", options.overrides}};
  std::vector<Variant> all;
  for (const char* penalty : {"5e6", "1e9", "1e12"}) {
    for (const char* step : {"1e-2", "1e-3"}) {
      Variant v{fmt::format(" p={} dt={}", penalty, step), options.overrides};
      v.overrides.push_back(fmt::format("contact.initial_penalty_n_per_m2={}", penalty));
      v.overrides.push_back(fmt::format("analysis.step_s={}", step));
      all.push_back(v);
    }
  }
  return all;
}

std::string number(const json& value) {
  return value.is_number() ? fmt::format("{:.9g}", value.get<double>()) : "none";
}

}  // namespace

int validate(const ValidateOptions& options) {
  std::string scratch = (fs::temp_directory_path() / "blockweir-validate-XXXXXX").string();
  if (::mkdtemp(scratch.data()) == nullptr)
    throw std::runtime_error("cannot make a folder in " + fs::temp_directory_path().string());
  json rows = json::array();
  bool sound = true;
  fmt::print("{:<46} {:<34} {:>16} {:>16} {:>10} {:>10} {:>8}\n", "case", "quantity", "expected", "got", "error",
             "tolerance", "time s");
  int count = 0;
  for (const fs::path& path : options.cases.empty() ? all_cases() : options.cases) {
    for (const Variant& variant : variants(options)) {
      const RunResult result =
          run({path, fs::path(scratch) / std::to_string(count++), variant.overrides, /*quiet=*/true});
      const std::string name = path.filename().string() + variant.name;
      if (result.exit_code != 0) {
        fmt::print("{:<46} {}\n", name, result.trouble);
        sound = false;
        if (result.exit_code == 130) {
          fs::remove_all(scratch);
          return 130;
        }
      }
      for (json check : result.summary.value("checks", json::array())) {
        const bool passed = result.exit_code == 0 && check["passed"].get<bool>();
        sound = sound && passed;
        fmt::print(
            "{:<46} {:<34} {:>16} {:>16} {:>10} {:>10} {:>8.3g}{}\n", name, check["name"].get<std::string>(),
            number(check["expected"]), number(check["got"]),
            check["relative_error"].is_number() ? fmt::format("{:.2e}", check["relative_error"].get<double>()) : "none",
            number(check["tolerance"]), result.summary["wall_time_s"].get<double>(), passed ? "" : "  OUT");
        std::fflush(stdout);
        check["case"] = name;
        check["wall_time_s"] = result.summary["wall_time_s"];
        rows.push_back(check);
      }
      fs::remove_all(result.folder);
    }
  }
  fs::remove_all(scratch);
  if (rows.empty()) {
    fmt::print("no case states a figure\n");
    return 1;
  }
  if (!options.json.empty() && !(std::ofstream(options.json) << rows.dump(2) << '\n')) {
    throw std::runtime_error("cannot write " + options.json.string());
  }
  fmt::print("{} figures, {}\n", rows.size(), sound ? "all within tolerance" : "NOT all within tolerance");
  return sound ? 0 : 1;
}

}  // namespace blockweir::launch
