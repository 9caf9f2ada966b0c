// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/strain_that_lets_go.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solid/answers/answer_entries.hpp"
#include "solid/answers/other_orders.hpp"

namespace blockweir::solid {
namespace {

using limit::Bearing;

constexpr const char* why = "rigid blocks stand as long as any forces in the joints hold them, and strain finds others";

scene::Scene with_straining_blocks(scene::Scene scene) {
  scene.analysis.rigid = scene::Rigid::none;
  for (scene::Block& block : scene.blocks) block.rigid = false;
  return scene;
}

/// More blocks with strain take minutes.
bool are_many(const scene::Scene& scene) {
  constexpr std::size_t many = 100;
  return scene.blocks.size() > many;
}

}  // namespace

bool stands_by_any_forces(const limit::LimitAnalysis& structure) {
  constexpr int few = 20;
  const scene::Scene& scene = structure.scene();
  const auto moving = std::count_if(scene.blocks.begin(), scene.blocks.end(), [](const auto& b) { return !b.fixed; });
  return moving > few && scene.bolts.empty() && !structure.is_exact() && !strains(scene);
}

void add_strain_that_lets_go(const limit::LimitAnalysis& structure, Situation& now, const StaticStrength& found,
                             std::optional<double> jumps_below, nlohmann::json& answer) {
  if (!stands_by_any_forces(structure) || found.bearing == Bearing::bears_none) return;
  const auto warn = [&](const std::string& text) { answer["warnings"].push_back(text); };
  if (are_many(now.scene)) {
    return warn(fmt::format("{}: the factor may be lower; analysis.rigid=none finds that, but takes long", why));
  }
  const scene::Scene straining = with_straining_blocks(now.scene);
  const auto with = attempt([&] { return strength_if_lower(straining, now, found, jumps_below); });
  if (!with.value) return warn(fmt::format("{}: the factor may be lower, which was not found: {}", why, with.why_not));
  if (with.value->bearing == Bearing::bears_any) return;
  const double factor = with.value->bearing == Bearing::bears_none ? 0 : with.value->factor;
  const std::string text =
      fmt::format("the same blocks with strain have a factor of {:.4g}: {}; the lower counts", factor, why);
  answer["with_straining_blocks"] = {{"factor", factor}, {"text", text}};
  warn(text);
}

void add_strain_that_lets_go(const limit::LimitAnalysis& structure, StillWater& water, const StaticLevel& found,
                             nlohmann::json& answer) {
  constexpr double share = 0.95;
  if (!stands_by_any_forces(structure) || found.outcome == limit::Filled::does_not_stand_empty) return;
  const auto warn = [&](const std::string& text) { answer["warnings"].push_back(text); };
  if (are_many(structure.scene())) {
    return warn(fmt::format("{}: they may fail at a lower level; analysis.rigid=none finds it, but takes long", why));
  }
  const double empty_m = water.range().empty_m;
  const double lower_m = empty_m + share * (found.level_m - empty_m);
  const scene::Scene straining = with_straining_blocks(structure.scene());
  const auto stand = attempt([&] { return stands(straining, &water, lower_m); });
  if (stand.value && *stand.value) return;
  warn(fmt::format("with strain the same blocks {} at {:.5g} m: {}; analysis.rigid=none finds their level",
                   stand.value ? "do not stand" : "are not known to stand", lower_m, why));
}

}  // namespace blockweir::solid
