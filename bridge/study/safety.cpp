// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "bridge/picture/mechanism.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/scene/read/entry.hpp"
#include "bridge/scene/read/gathered.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string folder_name(std::string name) {
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  }
  return name;
}

/// Does the factor that the blocks themselves have reach what is required? Null where nothing is, or where they have no
/// answer.
json satisfied(const json& answer, const std::optional<double>& required) {
  if (!required || answer["outcome"] == "not found") return nullptr;
  return answer["factor"].is_number() ? answer["factor"].get<double>() >= *required
                                      : answer["outcome"].get<std::string>() == "stands";
}

/// Asks for one case, draws its mechanism, and adds what the scene says of it.
json answer_of(const scene::LoadCase& load_case, const process::AskOptions& options) {
  const process::Asked asked = process::ask("safety", options);
  json answer = asked.answer;
  if (answer.contains("mechanism")) {
    const std::optional<double> level_m =
        answer["level_m"].is_number() ? std::optional(answer["level_m"].get<double>()) : std::nullopt;
    picture::draw_mechanism(asked.scene, answer["mechanism"], level_m, asked.folder / "mechanism.png");
  }
  answer["name"] = load_case.name;
  answer["class"] = load_case.kind;
  answer["set"] = load_case.set;
  answer["required"] = load_case.required_factor ? json(*load_case.required_factor) : json();
  answer["source"] = load_case.source;
  answer["satisfied"] = satisfied(answer, load_case.required_factor);
  return answer;
}

std::string scaled(const json& value, const char* format, double scale = 1) {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>() * scale) : "-";
}

std::string factors_text(const json& cases) {
  constexpr const char* row = "{:<24.24} {:<10.10} {:<9} {:>8} {:>8} {:>8} {:>8}\n";
  std::string text =
      fmt::format(fmt::runtime(row), "LOAD CASE", "class", "outcome", "factor", "limit", "required", "enough");
  for (const json& c : cases) {
    const json& enough = c["satisfied"];
    text += fmt::format(fmt::runtime(row), c["name"].get<std::string>(), c["class"].get<std::string>(),
                        c["outcome"].get<std::string>(), scaled(c["factor"], "{:.5g}"),
                        scaled(c["limit_analysis_factor"], "{:.5g}"), scaled(c["required"], "{:.4g}"),
                        enough.is_null()     ? "-"
                        : enough.get<bool>() ? "yes"
                                             : "NO");
  }
  for (const json& c : cases) {
    const auto tell = [&](const char* what, const json& why) {
      text += fmt::format("{}: {}{}\n", c["name"].get<std::string>(), what, why.get<std::string>());
    };
    if (c["outcome"] == "not found" && !c.contains("stopped")) tell("no answer: ", c["why_no_factor"]);
    if (c.contains("stopped")) tell("a lower bound, ", c["stopped"]);
    for (const json& warning : c["warnings"]) tell("WARNING ", warning);
  }
  return text +
         "factor: c and tan(phi) of all joints divided by it, the blocks just stand\n"
         "limit:  the same by limit analysis, an upper bound\n";
}

/// Forces of a metre of thickness.
std::string joints_text(const json& answer) {
  if (answer["joints"].empty()) return {};
  constexpr const char* row = "{:<16.16} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}\n";
  std::string text = fmt::format("\njoints that run through, {}{}\n", answer["name"].get<std::string>(),
                                 answer.contains("joints_with_strength_times")
                                     ? fmt::format(", with {:.4g} times the strength, as it does not stand",
                                                   answer["joints_with_strength_times"].get<double>())
                                     : "");
  text += fmt::format(fmt::runtime(row), "joint", "N kN/m", "T kN/m", "U kN/m", "sliding", "result.", "crack m",
                      "heel kPa", "toe kPa");
  for (const json& j : answer["joints"]) {
    text += fmt::format(fmt::runtime(row), j["name"].get<std::string>(), scaled(j["normal_n_per_m"], "{:.1f}", 1e-3),
                        scaled(j["shear_n_per_m"], "{:.1f}", 1e-3), scaled(j["uplift_n_per_m"], "{:.1f}", 1e-3),
                        scaled(j["sliding_factor"], "{:.4g}"), scaled(j["resultant_from_downstream"], "{:.4f}"),
                        scaled(j["cracked_length_m"], "{:.3f}"), scaled(j["heel_stress_pa"], "{:.1f}", 1e-3),
                        scaled(j["toe_stress_pa"], "{:.1f}", 1e-3));
  }
  return text;
}

}  // namespace

void require_sound(const scene::LoadCase& load_case, const fs::path& scene, const Settings& overrides) {
  scene::read_entry(scene, {fmt::format("[[load_case]] \"{}\"", load_case.name), load_case.line, load_case.set},
                    joined(load_case.set, overrides));
}

int tell_safety(const SafetyOptions& options) {
  if (!options.json.empty()) results::require_writable_file("--json", options.json);
  const std::vector<scene::LoadCase> load_cases = scene::read(options.scene, options.overrides).load_cases;
  scene::Gathered wrong;
  for (const scene::LoadCase& load_case : load_cases) {
    wrong.from([&] { require_sound(load_case, options.scene, options.overrides); });
  }
  wrong.report();
  json cases = json::array();
  fs::path folder = options.out;
  if (folder.empty()) folder = fs::path("runs") / (process::case_name(options.scene) + "-safety");
  const auto answer = [&](const scene::LoadCase& load_case, const fs::path& out, bool quiet) {
    process::AskOptions one = options;
    one.out = out;
    one.overrides = joined(load_case.set, options.overrides);
    one.quiet = quiet;
    cases.push_back(answer_of(load_case, one));
  };
  answer({.name = "as it stands"}, folder, /*quiet=*/false);
  for (const scene::LoadCase& load_case : load_cases) {
    answer(load_case, folder / folder_name(load_case.name), /*quiet=*/true);
  }
  const std::string all = json{{"load_cases", cases}}.dump(2) + "\n";
  results::replace_file(folder / "safety.json", all);
  if (!options.json.empty()) results::replace_file(options.json, all);
  std::string text = factors_text(cases);
  for (const json& c : cases) text += joints_text(c);
  fmt::print("{}results {} (safety.json, mechanism.png; a folder for each load case)\n", text, folder.string());
  return 0;
}

}  // namespace blockweir::study
