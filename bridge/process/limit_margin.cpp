// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/process/limit_margin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "bridge/process/programs.hpp"

namespace blockweir::process {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Why a factor is above 1 although the structure fails: it failed under a higher level than the scene's last, or the
/// factor is an upper bound.
std::string why_above_1(const json& found, const json& summary) {
  const json level_m = summary.value("failure", json::object()).value("level_m", json());
  if (found["level_m"].is_number() && level_m.is_number() && found["level_m"] < level_m) {
    return fmt::format("; above 1, as that is the scene's last level: it failed at {:.4g} m", level_m.get<double>());
  }
  return "; above 1 although it fails, as an upper bound may be";
}

std::string text_of(const json& found, const json& summary) {
  const bool fails = summary["outcome"] == "fails";
  const std::string level =
      found["level_m"].is_number() ? fmt::format(" at a level of {:.6g} m", found["level_m"].get<double>()) : "";
  const std::string note = found.contains("limit_analysis_note") && found.contains("mechanism")
                               ? "; " + found["limit_analysis_note"].get<std::string>()
                               : "";
  const auto how = [&] { return found["mechanism"]["text"].get<std::string>() + note; };
  const char* bound = found.value("upper_bound", false) ? "at most " : "";
  if (found["factor"].is_number()) {
    const double factor = found["factor"];
    const bool any_forces = !fails && found.value("stands_by_any_forces", false);
    const std::string mind =
        fails && factor >= 1 ? why_above_1(found, summary)
        : any_forces         ? "; so many rigid blocks stand as long as any forces in the joints hold them, and strain "
                               "may find others: \"blockweir safety\" asks"
                             : "";
    return fmt::format("{}{:.4g} on the strength of the joints{}: {}{}", bound, factor, level, how(), mind);
  }
  if (!fails && found.value("holds_nothing", false)) {
    return fmt::format(
        "not reported: it stands, although by limit analysis nothing holds the structure as it is drawn: {}", how());
  }
  if (found.contains("reservoir_factor")) {
    return fmt::format("{}{:.4g} on the reservoir's forces{}, as {}: {}", bound,
                       found["reservoir_factor"].get<double>(), level, found["why_no_factor"].get<std::string>(),
                       how());
  }
  const std::string why = found["why_no_factor"].get<std::string>() +
                          (found.contains("mechanism") ? ": " + found["mechanism"]["text"].get<std::string>() : "");
  if (!found.contains("limit_analysis_note")) return "none: " + why;
  return fmt::format("none: {}; {}", why, found["limit_analysis_note"].get<std::string>());
}

/// Of the last levels of a scene, in whose last window the blocks had others.
std::string doubt_of_last_levels(const json& found) {
  if (found.value("holds_nothing", false)) {
    return "it stands under the levels of the last window: under the last ones of the scene, by limit analysis, "
           "nothing holds it";
  }
  if (!found["factor"].is_number() || found["factor"] >= 1) return {};
  return fmt::format(
      "it stands under the levels of the last window: under the last ones of the scene the factor by limit analysis, "
      "an upper bound, is {:.4g}",
      found["factor"].get<double>());
}

/// A doubt if the upper bound of the scene as drawn is below 1 although the blocks stand; otherwise empty.
std::string doubt_of(const json& found, bool last_levels_acted) {
  if (!last_levels_acted) return doubt_of_last_levels(found);
  if (found.value("holds_nothing", false)) {
    return "it stands although by limit analysis nothing holds the structure as it is drawn: it has moved to where it "
           "stands, or corners that only meet in a point hold it, and uplift acts only in joints whose faces touch as "
           "drawn; let faces touch";
  }
  constexpr double of_strain = 1e-2;
  if (!found["factor"].is_number() || found["factor"] >= 1 - of_strain) return {};
  return fmt::format(
      "it stands although limit analysis, an upper bound, has a factor of {:.4g}: by that no forces hold the structure "
      "as it is drawn; it has moved to where it stands, or corners and slivers hold it; look at what has moved",
      found["factor"].get<double>());
}

}  // namespace

LimitMargin::LimitMargin(const fs::path& scratch) : answer_(scratch / "margin.json"), log_(scratch / "margin.log") {}

bool LimitMargin::suits(const scene::Scene& scene) {
  const bool still = scene.fluid == scene::FluidModel::none || scene::still_pools(scene.fluid);
  const bool any_moves =
      std::any_of(scene.blocks.begin(), scene.blocks.end(), [](const scene::Block& b) { return !b.fixed; });
  return still && any_moves && !scene.base_motion &&
         std::none_of(scene.blocks.begin(), scene.blocks.end(), [](const scene::Block& b) {
           return !b.initial_velocity_m_per_s.isZero() || b.initial_spin_deg_per_s != 0;
         });
}

Command LimitMargin::command(const fs::path& folder) const {
  Command command = limit_command(folder, "margin", answer_);
  command.output = log_;
  command.aside = true;
  return command;
}

void LimitMargin::add_to(json& summary) const {
  const std::string outcome = summary.value("outcome", "stopped");
  if (outcome != "fails" && outcome != "stands") return;
  json found = json::parse(std::ifstream(answer_), nullptr, /*allow_exceptions=*/false);
  if (!found.is_object()) {  // the run stands for itself
    std::string why = last_line(log_);
    // The text before it names the program and the run's copy of the scene, which the user does not
    // know.
    const std::string_view source = ": limit analysis: ";
    if (const auto at = why.find(source); at != std::string::npos) why.erase(0, at + source.size());
    found = {
        {"factor", nullptr}, {"level_m", nullptr}, {"why_no_factor", why.empty() ? "limit analysis was stopped" : why}};
  }
  found["text"] = text_of(found, summary);
  for (const json& warning : found.value("warnings", json::array())) summary["warnings"].push_back(warning);
  if (const std::string doubt = doubt_of(found, summary.value("last_levels_acted", true));
      outcome == "stands" && !doubt.empty()) {
    summary["warnings"].push_back(doubt);
  }
  summary["limit_analysis"] = found;
}

}  // namespace blockweir::process
