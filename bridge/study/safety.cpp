// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/safety.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/picture/mechanism.hpp"
#include "bridge/picture/section_state.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/results/file_name.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/gathered.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/scene/read/stated_loads.hpp"
#include "bridge/study/load_case_scene.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Does it reach what is required? Null where nothing is, or where the blocks have no answer.
json satisfied(const json& answer, const std::optional<double>& required) {
  if (!required || answer["outcome"] == "not found") return nullptr;
  return deciding_factor(answer) >= *required;
}

/// Has every case an answer, and is every factor that is required reached?
bool all_enough(const json& cases) {
  return std::all_of(cases.begin(), cases.end(), [](const json& c) {
    return c["outcome"] != "not found" && (c["required"].is_null() || c["satisfied"] == true);
  });
}

/// What a factor on the stated loads leaves as it is.
std::vector<std::string> constant_loads(const scene::Scene& scene) {
  std::vector<std::string> all{"weight"};
  if (!scene.bolts.empty()) all.emplace_back("bolts");
  if (scene.fluid != scene::FluidModel::none) all.emplace_back("water");
  if (scene.water.ice) all.emplace_back("ice");
  if (scene.water.earthquake_coefficient != 0) all.emplace_back("the earthquake's added water");
  return all;
}

/// The key of "key=value".
std::string key_of(const std::string& setting) {
  return setting.substr(0, setting.find('='));
}

/// Is one of two keys the other, or a table that holds it?
bool meet(const std::string& a, const std::string& b) {
  const auto& [shorter, longer] = std::minmax(a, b, [](const auto& x, const auto& y) { return x.size() < y.size(); });
  return longer == shorter || longer.starts_with(shorter + ".");
}

/// Of the command line's settings, those over which the load case goes with its own.
std::vector<std::string> without_effect(const Settings& overrides, const scene::LoadCase& load_case) {
  std::vector<std::string> warnings;
  for (const std::string& setting : overrides) {
    for (const std::string& own : load_case.set) {
      if (!meet(key_of(setting), key_of(own))) continue;
      warnings.push_back(fmt::format("--set {} is not what counts here: the load case sets {}", setting, own));
    }
  }
  return warnings;
}

/// Asks for one case, draws its mechanism, and adds what the scene says of it.
json answer_of(const scene::LoadCase& load_case, const process::AskOptions& options) {
  const process::Asked asked = process::ask("safety", options);
  json answer = asked.answer;
  const auto draw = [&](const json& found, const char* name) {
    const std::optional<double> level_m =
        answer["level_m"].is_number() ? std::optional(answer["level_m"].get<double>()) : std::nullopt;
    if (found.contains("mechanism")) {
      picture::draw_mechanism(asked.scene, found["mechanism"], level_m, asked.folder / name);
    }
  };
  draw(answer, "mechanism.png");
  draw(answer.value("load_factor", json::object()), "mechanism-loads.png");
  if (answer.contains("load_factor")) {
    answer["load_factor"]["loads"] = scene::stated_loads(asked.scene.text);
    answer["load_factor"]["constant"] = constant_loads(asked.scene);
  }
  json bolt_forces = json::array();
  for (const json& bolt : answer["bolts"]) bolt_forces.push_back(bolt["force_n_per_m"]);
  answer["section"] =
      picture::section_state(asked.scene, answer["water"], asked.scene.analysis.duration_s, bolt_forces);
  answer["name"] = load_case.name;
  answer["scene_warnings"] = asked.scene.warnings;
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

/// Which loads grow by the factor, and what stays as it is.
std::string load_factor_text(const json& found) {
  const auto list = [&](const char* key) {
    return fmt::format("{}", fmt::join(found[key].get<std::vector<std::string>>(), " and "));
  };
  return fmt::format("{:.5g} times {}, by limit analysis; as stated: {}", found["factor"].get<double>(), list("loads"),
                     list("constant"));
}

std::string factors_text(const json& cases) {
  constexpr const char* row = "{:<22.22} {:<7.7} {:<9} {:>7} {:>7} {:>7} {:>8} {:>6}\n";
  std::string text = fmt::format(fmt::runtime(row), "LOAD CASE", "class", "outcome", "level m", "factor", "limit",
                                 "required", "enough");
  for (const json& c : cases) {
    const json& enough = c["satisfied"];
    text += fmt::format(fmt::runtime(row), c["name"].get<std::string>(), c["class"].get<std::string>(),
                        c["outcome"].get<std::string>(), scaled(c["level_m"], "{:.5g}"), scaled(c["factor"], "{:.5g}"),
                        scaled(c["limit_analysis_factor"], "{:.5g}"), scaled(c["required"], "{:.4g}"),
                        enough.is_null()     ? "-"
                        : enough.get<bool>() ? "yes"
                                             : "NO");
  }
  for (const json& c : cases) {
    const auto tell = [&](const char* what, const json& why) {
      text += fmt::format("{}: {}{}\n", c["name"].get<std::string>(), what, why.get<std::string>());
    };
    if (c["tailwater_m"].is_number()) tell("tailwater at ", scaled(c["tailwater_m"], "{:.5g} m"));
    if (c["outcome"] == "not found" && !c.contains("stopped"))
      tell("no answer: ", c["why_no_factor"]);
    else if (c["factor"].is_null() && c.contains("why_no_factor"))
      tell("no factor: ", c["why_no_factor"]);
    if (c.contains("mechanism")) tell("mechanism: ", c["mechanism"]["text"]);
    if (c.contains("friction_history")) tell("factor: ", c["friction_history"]);
    if (c.contains("stopped")) tell("a lower bound, ", c["stopped"]);
    if (c.contains("water_factor")) {
      tell("it bears ", fmt::format("{:.5g} times what the water presses, by limit analysis",
                                    c["water_factor"]["factor"].get<double>()));
    }
    if (c.contains("load_factor")) {
      tell("it bears ", load_factor_text(c["load_factor"]));
    }
    if (c.contains("with_cracked_joint") && c["satisfied"] == false) {
      tell("not enough: ", c["with_cracked_joint"]["text"]);
    }
    if (c.contains("limit_analysis_note")) tell("limit: ", c["limit_analysis_note"]);
    for (const json& warning : c["scene_warnings"]) {  // those of the scene as it stands are told by its reading
      const json& told = cases[0]["scene_warnings"];
      if (std::find(told.begin(), told.end(), warning) == told.end()) tell("WARNING ", warning);
    }
    for (const json& warning : c["warnings"]) {  // what the first has said of all is not said again
      const json& told = cases[0]["warnings"];
      if (&c == &cases[0] || std::find(told.begin(), told.end(), warning) == told.end()) tell("WARNING ", warning);
    }
    if (c.contains("added_water_pressure")) {
      tell("the water's added pressure in the earthquake is after ", c["added_water_pressure"]);
    }
  }
  return text +
         "factor: c and tan(phi) of all joints divided by it, the blocks just stand\n"
         "limit:  the same by limit analysis, an upper bound\n";
}

/// What acts on all that stands on each joint; the joint bears their sum.
std::string sums_text(const json& joints, const char* last) {
  constexpr const char* row = "{:<32.32} {:>12} {:>12} {:>14}\n";
  std::string text;
  for (const json& j : joints) {
    const auto coordinate = [&](std::size_t i) {
      constexpr double rounding = 1e-9;
      const double x = j["downstream_end_m"][i];
      return std::abs(x) < rounding * j["length_m"].get<double>() ? 0 : x;
    };
    text += fmt::format("\nforces on what stands on {}, moments about ({:.4g}, {:.4g}) m\n",
                        j["name"].get<std::string>(), coordinate(0), coordinate(1));
    text += fmt::format(fmt::runtime(row), "", "x kN/m", "y kN/m", "moment kN");
    const auto add = [&](const std::string& name, double x, double y, double moment) {
      text += fmt::format(fmt::runtime(row), name, fmt::format("{:.2f}", x / 1e3), fmt::format("{:.2f}", y / 1e3),
                          fmt::format("{:.2f}", moment / 1e3));
    };
    double x = 0;
    double y = 0;
    double moment = 0;
    for (const json& s : j["sums"]) {
      add(s["name"], s["x_n_per_m"], s["y_n_per_m"], s["moment_n"]);
      x += s["x_n_per_m"].get<double>();
      y += s["y_n_per_m"].get<double>();
      moment += s["moment_n"].get<double>();
    }
    add(last, x, y, moment);
  }
  return text;
}

/// Forces of a metre of thickness.
std::string joints_text(const json& answer) {
  const json& joints = answer["joints"];
  if (answer.contains("why_no_joints")) {
    return fmt::format("\nno forces in joints, {}: {}\n", answer["name"].get<std::string>(),
                       answer["why_no_joints"].get<std::string>()) +
           sums_text(answer["loads_on_joints"], "sum");
  }
  if (joints.empty()) return {};
  constexpr const char* forces = "{:<20.20} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8}\n";
  constexpr const char* stresses = "{:<20.20} {:>9} {:>9} {:>9} {:>9} {:>9}\n";
  std::string text = fmt::format("\njoints that run through, {}{}\n", answer["name"].get<std::string>(),
                                 answer.contains("joints_with_strength_times")
                                     ? fmt::format(", with {:.4g} times the strength, as it does not stand",
                                                   answer["joints_with_strength_times"].get<double>())
                                     : "");
  text += fmt::format(fmt::runtime(forces), "joint", "N kN/m", "T kN/m", "U kN/m", "M kN", "sliding", "residual");
  for (const json& j : joints) {
    text += fmt::format(fmt::runtime(forces), j["name"].get<std::string>(), scaled(j["normal_n_per_m"], "{:.1f}", 1e-3),
                        scaled(j["shear_n_per_m"], "{:.1f}", 1e-3), scaled(j["uplift_n_per_m"], "{:.1f}", 1e-3),
                        scaled(j["moment_n"], "{:.1f}", 1e-3), scaled(j["sliding_factor"], "{:.4g}"),
                        scaled(j["residual_sliding_factor"], "{:.4g}"));
  }
  text += fmt::format(fmt::runtime(stresses), "joint", "result.", "pressed m", "crack m", "heel kPa", "toe kPa");
  for (const json& j : joints) {
    text += fmt::format(fmt::runtime(stresses), j["name"].get<std::string>(),
                        scaled(j["resultant_from_downstream"], "{:.4f}"), scaled(j["compressed_length_m"], "{:.3f}"),
                        scaled(j["cracked_length_m"], "{:.3f}"), scaled(j["heel_stress_pa"], "{:.1f}", 1e-3),
                        scaled(j["toe_stress_pa"], "{:.1f}", 1e-3));
  }
  constexpr std::size_t most = 4;  // of a mesh of joints the file has the rest
  return joints.size() > most ? text : text + sums_text(joints, "sum, which the joint bears");
}

}  // namespace

double deciding_factor(const json& answer) {
  double factor = answer["outcome"] == "stands" ? std::numeric_limits<double>::infinity() : 0;
  if (answer["factor"].is_number()) factor = answer["factor"];
  if (answer["limit_analysis_factor"].is_number())
    factor = std::min(factor, answer["limit_analysis_factor"].get<double>());
  for (const char* lower : {"with_crushed_corners", "with_cracked_joint", "above_upper_bound"}) {
    if (answer.contains(lower)) factor = std::min(factor, answer[lower]["factor"].get<double>());
  }
  return factor;
}

json safety_answers(const process::AskOptions& options) {
  const scene::ReadScene read = scene::read_variant(options.scene, options.variant, options.overrides);
  scene::Gathered wrong;
  for (const scene::LoadCase& load_case : read.load_cases) {
    wrong.from([&] { load_case_scene(load_case, options.scene, options.overrides); });
  }
  wrong.report();
  json cases = json::array();
  const auto answer = [&](const scene::LoadCase& load_case, const fs::path& out, bool quiet) {
    process::AskOptions one = options;
    one.out = out;
    one.overrides = joined(options.overrides, load_case.set);
    one.quiet = quiet;
    json found = answer_of(load_case, one);
    const scene::Scene with = scene::read_variant(one.scene, one.variant, one.overrides).scene;
    const auto idle = idle_load_case(load_case, read.scene, with);
    if (idle && !load_case.set.empty()) found["warnings"].push_back(idle->message());
    for (const scene::Diagnostic& missed : missed_joints(load_case, with)) {
      found["warnings"].push_back(missed.message());
    }
    for (std::string& warning : without_effect(options.overrides, load_case)) {
      found["warnings"].push_back(std::move(warning));
    }
    cases.push_back(std::move(found));
  };
  answer({.name = "as it stands"}, options.out, options.quiet);
  for (const scene::LoadCase& load_case : read.load_cases) {
    answer(load_case, options.out / results::file_name(load_case.name), /*quiet=*/true);
  }
  return cases;
}

int tell_safety(const SafetyOptions& options) {
  if (!options.json.empty()) results::require_writable_file("--json", options.json);
  process::AskOptions question = options;
  question.out = process::answer_folder("safety", options);
  const fs::path& folder = question.out;
  const json cases = safety_answers(question);
  const std::string all = json{{"load_cases", cases}}.dump(2) + "\n";
  results::replace_file(folder / "safety.json", all);
  if (!options.json.empty()) results::replace_file(options.json, all);
  std::string text = factors_text(cases);
  for (const json& c : cases) text += joints_text(c);
  const char* drawn = cases[0].contains("mechanism") ? ", mechanism.png" : "";
  text += fmt::format("results {} (safety.json{}; a folder for each load case)\n", folder.string(), drawn);
  fmt::print("{}", results::for_stdout(text));
  return all_enough(cases) ? 0 : 1;
}

}  // namespace blockweir::study
