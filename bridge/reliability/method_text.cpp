// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/reliability/method_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace blockweir::study {
namespace {

using nlohmann::json;

std::string at_point(const json& answer, const json& point) {
  std::string text;
  for (std::size_t i = 0; i < point.size(); ++i) {
    text += fmt::format("{}{} = {:.6g}", i == 0 ? "" : ", ", answer["variables"][i].get<std::string>(),
                        point[i].get<double>());
  }
  return text;
}

/// That a probability lies outside the interval of the samples, if it does.
std::string off_the_samples(const json& answer, const json& probability) {
  const json& interval = answer["samples"]["interval"];
  if (!probability.is_number() || !interval[0].is_number() || !interval[1].is_number()) return {};
  const double p = probability;
  if (p >= interval[0].get<double>() && p <= interval[1].get<double>()) return {};
  return fmt::format(
      "        outside the samples' interval, {} to {} (95 %): its approximation of the limit state may not fit;\n"
      "        trust the samples, or take more\n",
      digits_of(interval[0]), digits_of(interval[1]));
}

/// Of variables that change nothing at the means.
std::string what_the_means_do(const json& answer) {
  const json compared = answer.value("comparison", json::array());
  if (compared.empty()) return "where another way to fail governs";
  for (const auto& [by, found] : compared.front().items()) {
    if (by == "where" || found["trouble"] != "" || found["level_m"].is_number()) continue;
    return found["outcome"] == "does not stand empty" ? "where it does not stand empty"
                                                      : "where it stands at each level that is looked at";
  }
  return "where another way to fail governs";
}

/// Other ways to fail that are nearly as likely, and what a look at the means alone would not show.
std::string further_text(const json& answer, const json& found) {
  std::string text;
  const json further = found.value("further", json::array());
  for (const json& point : further) {
    text += fmt::format("        another: {}; P {}\n", at_point(answer, point["design_point"]),
                        digits_of(point["probability"], "{:.6g}"));
  }
  if (!further.empty()) {
    text += fmt::format("        each is a way to fail: P of all together is at most {}\n",
                        digits_of(found["at_most"], "{:.6g}"));
  }
  std::vector<std::string> idle;
  for (const json& i : found.value("without_effect_at_means", json::array())) {
    idle.push_back(answer["variables"][i.get<std::size_t>()]);
  }
  if (!idle.empty()) {
    text +=
        fmt::format("        without effect at the means, {}: {}\n", what_the_means_do(answer), fmt::join(idle, ", "));
  }
  return text;
}

std::string form_text(const json& answer, const char* method) {
  const json& found = answer[method];
  std::string text = fmt::format(
      "{:<8}P {}; index {}", method == std::string("form") ? "FORM" : "SORM",
      digits_of(method == std::string("form") ? found["probability"] : found["breitung"]["probability"], "{:.6g}"),
      digits_of(method == std::string("form") ? found["index"] : found["breitung"]["index"], "{:.5g}"));
  const bool by_sorm = method == std::string("sorm");
  const std::string off = off_the_samples(answer, by_sorm ? found["breitung"]["probability"] : found["probability"]);
  if (by_sorm) return text + " (Breitung)\n" + off;
  text += fmt::format("\n        design point: {}\n", at_point(answer, found["design_point"]));
  text += fmt::format("        importance {}: {}\n",
                      answer.value("correlated", false) ? "y^2/|y|^2, not alpha^2" : "alpha^2",
                      at_point(answer, found["importance"]));
  constexpr double near_m = 1e-4;
  if (std::abs(found["residual"].get<double>()) > near_m) {
    text += fmt::format("        WARNING the design point fails {:.2g} m off the level: trust the samples\n",
                        found["residual"].get<double>());
  }
  return text + further_text(answer, found) + off;
}

std::string simulated_text(const json& answer, const char* method) {
  const json& found = answer[method];
  return fmt::format("{:<8}P {}, {} to {} (95 %), {} samples\n", method == std::string("subset") ? "SUBSET" : "IMPORT.",
                     digits_of(found["probability"]), digits_of(found["interval"][0]), digits_of(found["interval"][1]),
                     found["evaluations"].get<int>());
}

std::string sobol_text(const json& answer) {
  const json& found = answer["sobol"];
  std::string text = "SOBOL   shares of the variance of the level\n";
  text += fmt::format("        {:<40} {:>7} {:>7}\n", "variable", "alone", "in all");
  for (std::size_t i = 0; i < answer["variables"].size(); ++i) {
    text += fmt::format("        {:<40.40} {:>7} {:>7}\n", answer["variables"][i].get<std::string>(),
                        digits_of(found["first"][i], "{:.3f}"), digits_of(found["total"][i], "{:.3f}"));
  }
  double below = 0;
  for (std::size_t i = 0; i < found["first"].size(); ++i) {
    below = std::max(below, found["first"][i].get<double>() - found["total"][i].get<double>());
  }
  if (constexpr double shown = 5e-4; below > shown) {
    text += fmt::format(
        "        a share in all is never below that alone: where it is, by up to {:.2g}, that is the noise of {} "
        "samples;\n        reliability.json has the intervals, more samples narrow them\n",
        below, found["evaluations"].get<int>());
  }
  return text;
}

}  // namespace

std::string digits_of(const json& value, const char* format) {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>()) : "-";
}

std::string method_text(const json& answer, const char* method) {
  if (!answer.contains(method)) return "";
  if (answer[method].contains("trouble")) {
    return fmt::format("NONE    by {}: {}\n", method, answer[method]["trouble"].get<std::string>());
  }
  const std::string name = method;
  if (name == "sobol") return sobol_text(answer);
  return name == "form" || name == "sorm" ? form_text(answer, method) : simulated_text(answer, method);
}

}  // namespace blockweir::study
