// SPDX-License-Identifier: GPL-3.0-or-later
// The factor on strength by which a scene fails, found by the blocks' own equilibrium and by limit analysis.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "bridge/process/answers.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/answers/contradiction.hpp"
#include "solid/answers/crushed_corners.hpp"
#include "solid/answers/growing_cracks.hpp"
#include "solid/answers/joint_answer.hpp"
#include "solid/answers/other_orders.hpp"
#include "solid/answers/safety_reserves.hpp"
#include "solid/answers/strain_that_lets_go.hpp"
#include "solid/answers/water_by_kind.hpp"
#include "solid/capacity/situation.hpp"
#include "solid/capacity/static_strength.hpp"
#include "solid/limit/determinacy.hpp"
#include "solid/limit/limit_strength.hpp"
#include "solid/output/water_on_crest.hpp"

namespace blockweir::process {
namespace {

using nlohmann::json;
using solid::Attempt;
using solid::Situation;
using solid::StaticStrength;
using solid::limit::Bearing;
namespace limit = solid::limit;

/// A factor, or the reason why there is none; both methods have these fields.
template <class Strength>
void add_factor(const Attempt<Strength>& found, const char* key, const char* why, json& answer) {
  const bool has_one = found.value && found.value->bearing == Bearing::fails_at_a_factor;
  answer[key] = has_one ? json(found.value->factor) : json();
  if (has_one) return;
  answer[why] =
      !found.value ? found.why_not
      : found.value->bearing == Bearing::bears_any
          ? (answer["limit_analysis_factor"].is_number() ? "blocks stand with next to no strength of the joints"
                                                         : "no joint needs shear strength")
          : "no shear strength of the joints would hold the structure";
}

/// Blocks cannot carry more than limit analysis says, except through strain. Those that do hold each other at slivers
/// and tips, by less than the failure displacement.
void add_what_is_above_the_bound(const StaticStrength& blocks, const limit::LimitStrength& bound, json& answer) {
  constexpr double of_strain = 1e-2;
  if (bound.bearing != Bearing::fails_at_a_factor || blocks.bearing == Bearing::bears_none) return;
  if (blocks.bearing == Bearing::fails_at_a_factor && blocks.factor < bound.factor * (1 + of_strain)) return;
  const std::string text = fmt::format(
      "the blocks' factor lies above {:.5g}, which is an upper bound: the lower counts; blocks hold each other at thin "
      "tips or slivers, or an anchor has stretched: look at what moves in a run with less strength",
      bound.factor);
  answer["above_upper_bound"] = {{"factor", bound.factor}, {"text", text}};
  answer["warnings"].push_back(text);
}

/// Where equilibrium does not determine friction: the blocks' factor below which it has a part in it.
std::optional<double> jumps_below(const limit::LimitAnalysis& structure, const limit::LimitStrength& bound) {
  constexpr double of_friction = 1e-2;  // less is what blocks strain
  if (structure.is_exact() || !structure.scene().bolts.empty()) return std::nullopt;
  if (bound.bearing != Bearing::fails_at_a_factor) return std::nullopt;
  return bound.factor * (1 - of_friction);
}

/// Between the blocks' factor and the bound there are forces in the joints that balance the loads within Coulomb's law,
/// those of limit analysis, and others under which blocks slide: equilibrium does not say which come about.
void add_friction_history(const limit::LimitAnalysis& structure, const StaticStrength& blocks,
                          const limit::LimitStrength& bound, json& answer) {
  const std::optional<double> below = jumps_below(structure, bound);
  if (!below || !blocks.stopped.empty()) return;
  constexpr double next_to_nothing = 1e-3;
  if (blocks.bearing != Bearing::fails_at_a_factor || (blocks.factor > *below && !blocks.creeps && !blocks.by_motion))
    return;
  if (blocks.factor > bound.factor * (1 - next_to_nothing)) return;
  if (blocks.by_motion) {
    answer["friction_history"] = fmt::format(
        "blocks wedge each other, and statics step by step gets to no end; let go as drawn, under all loads at once, "
        "the blocks come to rest with strength over {:.4g} and fail with strength over {:.4g}; up to {:.4g} some "
        "forces in the joints would hold the structure",
        blocks.factor - blocks.width / 2, blocks.factor + blocks.width / 2, bound.factor);
    return;
  }
  if (limit::each_joint_divides(structure.scene(), structure.faces())) {
    answer["friction_history"] = fmt::format(
        "the bond of a joint breaks from its most stressed end on, which the blocks follow, down to {:.4g}; limit "
        "analysis, with {:.4g}, has all of the bond at once",
        blocks.factor, bound.factor);
    return;
  }
  answer["friction_history"] = fmt::format(
      "with strength over {:.4g} to {:.4g}, as far as these analyses found, some forces in the joints hold the "
      "structure and others do not; which come about depends on how it was loaded, so that the blocks' factor may jump "
      "between these from one level, drain or bond to the next, and a run may fail below them; compare such measures "
      "by "
      "the factors of limit analysis",
      blocks.factor, bound.factor);
}

const char* outcome(const Attempt<StaticStrength>& blocks) {
  if (!blocks.value) return "not found";
  if (blocks.value->factor < 1 && blocks.value->factor + blocks.value->width > 1 && !blocks.value->stopped.empty()) {
    return "not found";
  }
  const bool stands = blocks.value->bearing == Bearing::bears_any ||
                      (blocks.value->bearing != Bearing::bears_none && blocks.value->factor >= 1);
  return stands ? "stands" : "fails";
}

json warnings_of_water(Situation& now) {
  if (!now.water) return json::array();
  json warnings = now.water->warnings();
  const std::string crest = solid::output::water_on_crest_warning(now.scene, now.level_m);
  if (!crest.empty()) warnings.push_back(crest);
  return warnings;
}

/// The factor of the stated loads, beside weight and water, at which the structure fails.
void add_load_factor(const limit::LimitAnalysis& structure, const limit::Wrenches& dead, const limit::Wrenches& stated,
                     json& answer) {
  const auto loads = solid::attempt([&] { return structure.largest_factor(dead, stated); });
  if (!loads.value) return;
  if (loads.value->bearing == Bearing::fails_at_a_factor) {
    answer["load_factor"] = {{"factor", loads.value->factor},
                             {"gap", loads.value->gap},
                             {"mechanism", solid::mechanism_json(structure, loads.value->mechanism)}};
  } else if (loads.value->bearing == Bearing::bears_none &&
             std::any_of(stated.begin(), stated.end(), [](const auto& load) { return !load.isZero(); })) {
    answer["load_factor"] = {{"factor", nullptr}};  // what does not grow is too much already
  }
}

/// Where equilibrium does not determine friction: the same blocks with other strain and in other orders.
void add_what_friction_decides(const limit::LimitAnalysis& structure, Situation& now, const FluidMaker& make_fluid,
                               const StaticStrength& blocks, const limit::LimitStrength& bound, json& answer) {
  add_friction_history(structure, blocks, bound, answer);
  const auto jumps = jumps_below(structure, bound);
  solid::add_rigid_blocks(structure, now, blocks, jumps, answer);
  solid::add_strain_that_lets_go(structure, now, blocks, jumps, answer);
  solid::add_strength_in_other_orders(structure, make_fluid, blocks, jumps, answer);
}

}  // namespace

json safety_answer(const scene::Scene& scene, const FluidMaker& make_fluid) {
  Situation now(scene, make_fluid);
  const limit::LimitAnalysis structure(scene);
  solid::announce_limit_analysis(structure);
  const limit::Wrenches stated = statics::stated_loads_of(scene, scene.analysis.duration_s);
  const limit::Wrenches dead = now.dead();
  const auto by_limit =
      solid::attempt([&] { return limit::limit_strength(structure, limit::combined(dead, 1, stated)); });
  const bool has_limit = by_limit.value && by_limit.value->bearing == Bearing::fails_at_a_factor;
  const double guess = has_limit ? by_limit.value->factor : 1;
  const auto blocks = solid::attempt([&] {
    // Its search goes through all strengths, and those too weak creep for long.
    const bool none = by_limit.value && by_limit.value->bearing == Bearing::bears_none;
    if (none && !solid::stands(scene, now.water_if_any(), now.level_m)) return StaticStrength{};
    return solid::static_strength(scene, now.water_if_any(), now.level_m, guess,
                                  by_limit.value ? jumps_below(structure, *by_limit.value) : std::nullopt);
  });
  if (!blocks.value && !by_limit.value) throw std::runtime_error(blocks.why_not + "; " + by_limit.why_not);
  json answer = {{"outcome", outcome(blocks)}, {"level_m", std::isnan(now.level_m) ? json() : json(now.level_m)}};
  const auto& tailwater = scene.water.downstream_level_m;
  answer["tailwater_m"] = tailwater ? json(tailwater->at(scene.analysis.duration_s)) : json();
  add_factor(by_limit, "limit_analysis_factor", "why_no_limit_analysis_factor", answer);
  add_factor(blocks, "factor", "why_no_factor", answer);
  if (blocks.value) answer["factor_width"] = blocks.value->width;
  if (blocks.value && !blocks.value->stopped.empty()) answer["stopped"] = blocks.value->stopped;
  solid::add_what_limit_analysis_takes(structure, answer);
  if (has_limit) answer["gap"] = by_limit.value->gap;
  if (has_limit && by_limit.value->jams) solid::add_note(solid::jams_note, answer);
  if (by_limit.value && by_limit.value->bearing != Bearing::bears_any) {
    answer["mechanism"] = solid::mechanism_json(structure, by_limit.value->mechanism);
  }
  add_load_factor(structure, dead, stated, answer);
  solid::add_water_in_an_earthquake(scene, answer);
  answer["joints"] = json::array();
  answer["joint_parts"] = json::array();
  answer["bent_joints"] = json::array();
  answer["bolts"] = json::array();
  answer["water"] = now.water ? solid::water_by_kind(scene, make_fluid, now.level_m) : json::array();
  answer["warnings"] = warnings_of_water(now);
  solid::add_motion_left_out(scene, answer);
  solid::add_moved_supports(scene, answer);
  const limit::Wrenches loads = limit::combined(dead, 1, stated);
  if (by_limit.value && blocks.value) {
    solid::add_contradiction(*blocks.value, *by_limit.value, answer);
    add_what_is_above_the_bound(*blocks.value, *by_limit.value, answer);
    add_what_friction_decides(structure, now, make_fluid, *blocks.value, *by_limit.value, answer);
    solid::add_brittle_bonds(structure, now, *blocks.value, loads, answer);
  }
  if (by_limit.value) solid::add_water_factor(structure, now, stated, *by_limit.value, answer);
  solid::add_growing_cracks(now, make_fluid, answer);
  if (blocks.value) solid::add_stretch_of_anchors(now, *blocks.value, answer);
  if (by_limit.value) {
    solid::add_strength_with_crushed_corners(structure, loads, *by_limit.value, answer);
  }
  const bool as_drawn = answer["outcome"] != "not found" || !answer.contains("contradiction");
  if (blocks.value && as_drawn)
    solid::attempt([&] { return solid::add_joints(now, make_fluid, *blocks.value, answer), true; });
  return answer;
}

json water_answer(const scene::Scene& scene, const FluidMaker& make_fluid) {
  Situation now(scene, make_fluid);
  return now.water ? solid::water_by_kind(scene, make_fluid, now.level_m) : json::array();
}

}  // namespace blockweir::process
