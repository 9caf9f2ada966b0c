// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/level_doubt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "bridge/scene/constant_loads.hpp"

namespace blockweir::solid::output {
namespace {

/// What answers the level at rest: "level" raises the upstream pool.
std::string at_rest_text(const Failure& f) {
  return f.falls || f.downstream ? "kind = \"static\" at single levels finds the static level"
                                 : "\"blockweir level SCENE\" finds the static level";
}

/// Does the water stay below all that failed?
bool is_below(const scene::Scene& scene, const Failure& f) {
  const auto above = [&](int block) {
    const auto& corners = scene.blocks[at(block)].vertices;
    return std::all_of(corners.begin(), corners.end(), [&](const scene::Point& p) { return p.y() >= f.level_m; });
  };
  return !f.blocks.empty() && std::all_of(f.blocks.begin(), f.blocks.end(), above);
}

/// Of a level that was too high, or too low, from the start.
std::string bound_doubt(const scene::Scene& scene, const Failure& f) {
  if (!scene.base_motion && is_below(scene, f)) {
    return "it moves from the start, and the water lies below it: look at its weight, its joints and what it stands on";
  }
  if (scene.analysis.kind == scene::AnalysisKind::at_rest) {
    return "a static analysis looks at one level: try lower ones, or let the level rise in a dynamic analysis";
  }
  if (scene.base_motion) return "it moves from the start, while the ground shakes: a lower level may not hold it";
  if (scene::level_is_constant(scene, f.downstream)) {
    return "it moves from the start, under a level that does not change: " + at_rest_text(f);
  }
  return fmt::format("it moves from the start: begin with a {} level", f.falls ? "higher" : "lower");
}

}  // namespace

std::string level_doubt(const scene::Scene& scene, const Failure& f) {
  if (f.bound && f.joint.empty() && f.mode != "lifting")
    return "it falls from the start: nothing holds it where it is drawn";
  if (std::isnan(f.level_m)) return {};
  if (f.bound) return bound_doubt(scene, f);
  if (scene::level_is_constant(scene, f.downstream)) {
    if (scene.base_motion) return {};
    return "the level is constant: another load brings the failure; kind = \"static\" shows whether it stands at rest "
           "under this level";
  }
  constexpr double exact = 1e-3;  // of the head
  if (!(f.level_uncertainty_m > exact * std::abs(f.head_m))) return {};
  if (f.window_rise_m > f.level_uncertainty_m / 2) {
    return fmt::format(
        "this level is read to {:.2g} m, as it {} by {:.2g} m in one window: {} more slowly or shorten window_s",
        f.level_uncertainty_m, f.falls ? "falls" : "rises", f.window_rise_m, f.falls ? "empty" : "fill");
  }
  if (scene.base_motion) return fmt::format("the ground shakes: this level is read to {:.2g} m", f.level_uncertainty_m);
  return fmt::format(
      "this level depends on the speed of {}, by some {:.2g} m; {}, which may differ by more, as friction "
      "depends on how the loads came: go by the {} one",
      f.falls ? "emptying" : "filling", f.level_uncertainty_m, at_rest_text(f), f.falls ? "higher" : "lower");
}

}  // namespace blockweir::solid::output
