// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/safety_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "bridge/geometry/place_text.hpp"
#include "bridge/study/safety.hpp"

namespace blockweir::study {
namespace {

using geometry::without_signed_zero;
using nlohmann::json;

std::string scaled(const json& value, const char* format, double scale = 1) {
  return value.is_number() ? without_signed_zero(fmt::format(fmt::runtime(format), value.get<double>() * scale)) : "-";
}

/// The loads that the factor multiplies, and those that stay constant.
std::string load_factor_text(const json& found) {
  const auto list = [&](const char* key) -> std::string {
    auto names = found[key].get<std::vector<std::string>>();
    std::replace(names.begin(), names.end(), std::string("[earthquake]"), std::string("the inertia of [earthquake]"));
    if (names.size() < 2) return names.empty() ? "" : names.front();
    return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
  };
  if (found["factor"].is_null()) {
    return fmt::format("it does not stand under {} alone, even without {} (limit analysis)", list("constant"),
                       list("loads"));
  }
  return fmt::format("it bears {:.5g} times {}, by limit analysis; held as stated: {}", found["factor"].get<double>(),
                     list("loads"), list("constant"));
}

/// The lower factor on the water decides. Of what fails a higher one would read as if it stood.
std::string water_factor_text(const json& found, bool fails) {
  const std::string bears = found["factor"].is_null()
                                ? "it does not stand even without the water's pressure"
                                : scaled(found["factor"], "it bears {:.5g} times what the water presses") +
                                      (found.value("keeps_cracks", false) ? " while cracks stay as they are" : "");
  if (!found.contains("with_anchors_at_yield")) {
    return bears + (found["factor"].is_null() ? " (limit analysis)" : ", by limit analysis");
  }
  const json& at_yield = found["with_anchors_at_yield"];
  return bears + " with anchors at their prestress" +
         (at_yield.is_null() || fails ? "" : scaled(at_yield, ", {:.5g} times with anchors at their yield force")) +
         ", by limit analysis";
}

/// A name at the start of a row of figures; one that is longer than its column has a line of its own above them.
std::string beside(const std::string& name, std::size_t column) {
  return name.size() <= column ? name : name + "\n" + std::string(column, ' ');
}

/// What is told of a case below the table. `first`: what it has said of all is not said again.
std::vector<std::string> lines_of(const json& c, const json& first) {
  std::vector<std::string> lines;
  const auto add_line = [&](const std::string& what, const json& why) {
    lines.push_back(what + why.get<std::string>());
  };
  if (c["tailwater_m"].is_number()) add_line("tailwater at ", scaled(c["tailwater_m"], "{:.5g} m"));
  if (c["outcome"] == "not found" && !c.contains("stopped"))
    add_line("no answer: ", c["why_no_factor"]);
  else if (c["factor"].is_null() && c.contains("why_no_factor"))
    add_line("no factor: ", c["why_no_factor"]);
  const std::string no_limit = c.value("why_no_limit_analysis_factor", "");
  if (!no_limit.empty() && no_limit != c.value("why_no_factor", "")) add_line("no limit: ", no_limit);
  if (c.contains("mechanism")) add_line("mechanism: ", c["mechanism"]["text"]);
  if (c.contains("friction_history")) add_line("factor: ", c["friction_history"]);
  if (c.contains("stopped")) add_line("a lower bound, ", c["stopped"]);
  const auto is_told = [&](const char* key) {  // of what fails an upper bound above 1 would read as if it stood
    if (!c.contains(key)) return false;
    const json& factor = c[key]["factor"];
    return c["outcome"] != "fails" || !factor.is_number() || factor < 1;
  };
  if (is_told("water_factor")) {
    add_line("", water_factor_text(c["water_factor"], c["outcome"] == "fails"));
  }
  if (is_told("load_factor")) add_line("", load_factor_text(c["load_factor"]));
  if (c.contains("with_cracked_joint")) {
    const json& cracked = c["with_cracked_joint"];
    if (c["satisfied"] == false || cracked["factor"] == deciding_factor(c))
      add_line(c["satisfied"] == false ? "not enough: " : "the factor that decides: ", cracked["text"]);
  }
  const bool noted = &c != &first && c.value("limit_analysis_note", "") == first.value("limit_analysis_note", "");
  if (c.contains("limit_analysis_note") && !noted) add_line("limit: ", c["limit_analysis_note"]);
  const auto add_warnings = [&](const char* key, bool all) {
    for (const json& warning : c[key]) {
      if (all || std::find(first[key].begin(), first[key].end(), warning) == first[key].end())
        add_line("WARNING ", warning);
    }
  };
  add_warnings("scene_warnings", false);  // those of the scene itself were printed when it was read
  add_warnings("warnings", &c == &first);
  if (c.contains("added_water_pressure"))
    add_line("the water's added pressure in the earthquake is after ", c["added_water_pressure"]);
  return lines;
}

/// What is told of the cases, once for all that it holds for.
std::string told_of(const json& cases, const char* of_all) {
  std::vector<std::pair<std::string, std::vector<std::string>>> told;  // a line, and the names of cases
  for (const json& c : cases) {
    for (const std::string& line : lines_of(c, cases[0])) {
      auto same = std::find_if(told.begin(), told.end(), [&](const auto& one) { return one.first == line; });
      if (same == told.end()) same = told.insert(told.end(), {line, {}});
      same->second.push_back(c["name"]);
    }
  }
  std::string text;
  for (const auto& [line, names] : told) {
    const bool all = names.size() == cases.size() && names.size() > 1;
    const std::string some = names.size() == 1 ? names.front() : fmt::format("\"{}\"", fmt::join(names, "\", \""));
    text += fmt::format("{}: {}\n", all ? of_all : some, line);
  }
  return text;
}

std::string factors_text(const json& cases, const char* of_all) {
  constexpr const char* row = "{:<22} {:<7.7} {:<9} {:>7} {:>7} {:>7} {:>8} {:>6}\n";
  std::string text = fmt::format(fmt::runtime(row), "LOAD CASE", "class", "outcome", "level m", "factor", "limit",
                                 "required", "enough");
  for (const json& c : cases) {
    const json& enough = c["satisfied"];
    text += fmt::format(fmt::runtime(row), beside(c["name"], 22), c["class"].get<std::string>(),
                        c["outcome"].get<std::string>(), scaled(c["level_m"], "{:.5g}"), scaled(c["factor"], "{:.5g}"),
                        scaled(c["limit_analysis_factor"], "{:.5g}"), scaled(c["required"], "{:.4g}"),
                        enough.is_null()     ? "-"
                        : enough.get<bool>() ? "yes"
                                             : "NO");
  }
  const bool fails_unasked = std::any_of(
      cases.begin(), cases.end(), [](const json& c) { return c["outcome"] == "fails" && c["required"].is_null(); });
  return text + told_of(cases, of_all) +
         "factor: c and tan(phi) of all joints divided by it, the blocks just stand\n"
         "limit:  the same by limit analysis, an upper bound\n" +
         (fails_unasked
              ? "enough: what fails has no required_factor in a [[load_case]], so the exit status is not 1 for it\n"
              : "");
}

/// Joints of one name, as those of a set, with their elevations.
json with_elevations(json joints) {
  std::map<std::string, int> count;
  for (const json& j : joints) ++count[j["name"]];
  for (json& j : joints) {
    if (count[j["name"]] < 2) continue;
    const double end_m = j["downstream_end_m"][1];
    const double other_m = j.contains("upstream_end_m") ? j["upstream_end_m"][1].get<double>() : end_m;
    const double step_m = std::pow(10, std::floor(std::log10(1e-3 * j["length_m"].get<double>())));
    const std::string low = scaled(step_m * std::round(std::min(end_m, other_m) / step_m), "{:.6g}");
    const std::string high = scaled(step_m * std::round(std::max(end_m, other_m) / step_m), "{:.6g}");
    j["name"] = fmt::format("{}, {}{} m", j["name"].get<std::string>(), low, high == low ? "" : " to " + high);
  }
  return joints;
}

/// Loads on everything above each joint; the joint carries their sum.
std::string sums_text(const json& joints, const char* last) {
  constexpr const char* row = "{:<32.32} {:>12} {:>12} {:>14}\n";
  std::string text;
  for (const json& j : joints) {
    const json& about = j["downstream_end_m"];
    text += fmt::format(
        "\nforces on what stands on {}, moments about {} m\n", j["name"].get<std::string>(),
        geometry::place_text(geometry::Point(about[0].get<double>(), about[1].get<double>()), j["length_m"]));
    text += fmt::format(fmt::runtime(row), "", "x kN/m", "y kN/m", "moment kNm/m");
    const auto add = [&](const std::string& name, double x, double y, double moment) {
      text += fmt::format(fmt::runtime(row), name, scaled(x, "{:.2f}", 1e-3), scaled(y, "{:.2f}", 1e-3),
                          scaled(moment, "{:.2f}", 1e-3));
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

constexpr const char* joints_legend =
    "\nper metre of dam: N effective normal force (U is deducted), T shear, U uplift,\n"
    "M moment of N about the joint's middle (> 0: N acts downstream); sliding: strength\n"
    "over T; residual: without the bond; result.: its distance from the downstream end\n"
    "over the length\n";

/// Joints that divide the structure and have no row.
std::string bent_joints_text(const json& answer) {
  const auto names = answer.value("bent_joints", std::vector<std::string>());
  if (names.empty()) return {};
  return fmt::format(
      "no row for joint{} \"{}\", {}: several planes have no single sliding factor, nor resultant; the factor of the "
      "load case counts {}\n",
      names.size() > 1 ? "s" : "", fmt::join(names, "\", \""), names.size() > 1 ? "which bend" : "which bends",
      names.size() > 1 ? "them" : "it");
}

/// Joints of the mechanism that alone do not divide the structure.
std::string joint_parts_text(const json& answer) {
  const json parts = answer.value("joint_parts", json::array());
  if (parts.empty()) return {};
  constexpr const char* row = "{:<20} {:>9} {:>9} {:>9} {:>9} {:>13}\n";
  std::string text = fmt::format(
      "\nparts of a surface, {}: joints of the mechanism that part blocks only\n"
      "with others, and so have no factor of their own; strength: c L + N tan(phi)\n",
      answer["name"].get<std::string>());
  text += fmt::format(fmt::runtime(row), "joint", "L m", "N kN/m", "T kN/m", "U kN/m", "strength kN/m");
  for (const json& j : parts) {
    text += fmt::format(fmt::runtime(row), beside(j["name"], 20), scaled(j["length_m"], "{:.3f}"),
                        scaled(j["normal_n_per_m"], "{:.1f}", 1e-3), scaled(j["shear_n_per_m"], "{:.1f}", 1e-3),
                        scaled(j["uplift_n_per_m"], "{:.1f}", 1e-3), scaled(j["strength_n_per_m"], "{:.1f}", 1e-3));
  }
  return text;
}

/// Forces of a metre of thickness.
std::string joints_text(const json& answer) {
  const json joints = with_elevations(answer["joints"]);
  if (answer.contains("why_no_joints")) {
    return fmt::format("\nno forces in joints, {}: {}\n", answer["name"].get<std::string>(),
                       answer["why_no_joints"].get<std::string>()) +
           sums_text(with_elevations(answer["loads_on_joints"]), "sum");
  }
  if (joints.empty()) return bent_joints_text(answer) + joint_parts_text(answer);
  constexpr const char* forces = "{:<20} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8}\n";
  constexpr const char* stresses = "{:<20} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n";
  std::string text =
      fmt::format("\njoints that run through, {}{}\n", answer["name"].get<std::string>(),
                  answer.contains("joints_with_strength_times")
                      ? fmt::format(", with {:.4g} times the strength, as it does not stand (sliding and "
                                    "residual: with the strength as stated)",
                                    answer["joints_with_strength_times"].get<double>())
                      : "");
  text += fmt::format(fmt::runtime(forces), "joint", "N kN/m", "T kN/m", "U kN/m", "M kNm/m", "sliding", "residual");
  for (const json& j : joints) {
    text += fmt::format(fmt::runtime(forces), beside(j["name"], 20), scaled(j["normal_n_per_m"], "{:.1f}", 1e-3),
                        scaled(j["shear_n_per_m"], "{:.1f}", 1e-3), scaled(j["uplift_n_per_m"], "{:.1f}", 1e-3),
                        scaled(j["moment_n"], "{:.1f}", 1e-3), scaled(j["sliding_factor"], "{:.4g}"),
                        scaled(j["residual_sliding_factor"], "{:.4g}"));
  }
  text += fmt::format(fmt::runtime(stresses), "joint", "result.", "pressed m", "crack m", "bonded m", "heel kPa",
                      "toe kPa");
  for (const json& j : joints) {
    text += fmt::format(fmt::runtime(stresses), beside(j["name"], 20), scaled(j["resultant_from_downstream"], "{:.4f}"),
                        scaled(j["compressed_length_m"], "{:.3f}"), scaled(j["cracked_length_m"], "{:.3f}"),
                        scaled(j["bonded_length_m"], "{:.3f}"), scaled(j["heel_stress_pa"], "{:.1f}", 1e-3),
                        scaled(j["toe_stress_pa"], "{:.1f}", 1e-3));
  }
  text += bent_joints_text(answer) + joint_parts_text(answer);
  constexpr std::size_t most = 4;  // of a mesh of joints the file has the rest
  return joints.size() > most ? text : text + sums_text(joints, "sum, which the joint bears");
}

}  // namespace

std::string safety_text(const json& cases, const char* of_all) {
  std::string text = factors_text(cases, of_all);
  std::string joints;
  for (const json& c : cases) {
    const bool as_written = &c != &cases[0] && c["set"].empty();  // whose table is the first
    if (!as_written) joints += joints_text(c);
  }
  return joints.empty() ? text : text + joints_legend + joints;
}

}  // namespace blockweir::study
