// SPDX-License-Identifier: GPL-3.0-or-later
// The level at which a scene fails, found by the blocks' own equilibrium and by limit analysis, and what these two
// differ by.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bridge/process/answers.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/answers/crushed_corners.hpp"
#include "solid/answers/found_levels.hpp"
#include "solid/answers/strain_that_lets_go.hpp"
#include "solid/capacity/static_level.hpp"
#include "solid/expect/formula_tables.hpp"
#include "solid/expect/formulas.hpp"
#include "solid/limit/limit_level.hpp"
#include "solid/output/water_on_crest.hpp"

namespace blockweir::process {
namespace {

using nlohmann::json;
using solid::Attempt;
using solid::FoundLevels;
using solid::StaticLevel;
using solid::StillWater;
using solid::limit::Filled;
namespace limit = solid::limit;

/// Fields common to all outcomes, and the failure level.
json outcome_json(Filled outcome, double level_m) {
  switch (outcome) {
    case Filled::does_not_stand_empty:
      return {{"outcome", "does not stand empty"}, {"level_m", nullptr}};
    case Filled::stands_full:
      return {{"outcome", "stands"}, {"level_m", nullptr}, {"highest_level_m", level_m}};
    default:
      return {{"outcome", "fails"}, {"level_m", level_m}};
  }
}

json not_found_json(const std::string& why) {
  return {{"outcome", "not found"}, {"level_m", nullptr}, {"reason", why}};
}

json limit_json(const limit::LimitAnalysis& structure, const Attempt<limit::LimitLevel>& by_limit) {
  if (!by_limit.value) return not_found_json(by_limit.why_not);
  const limit::LimitLevel& found = *by_limit.value;
  json answer = outcome_json(found.outcome, found.level_m);
  answer["programs"] = found.programs;
  if (found.outcome == Filled::does_not_stand_empty) {
    answer["mechanism"] = solid::mechanism_json(structure, found.at_it.mechanism);
    return answer;
  }
  if (found.at_it.bearing != limit::Bearing::fails_at_a_factor) return answer;
  if (std::isfinite(found.at_it.gap)) answer["gap"] = found.at_it.gap;  // none where nothing resists
  if (found.outcome == Filled::stands_full) {
    answer["load_factor"] = found.at_it.factor;
    return answer;
  }
  const limit::MechanismDescription words = limit::words_of(structure, found.at_it.mechanism);
  if (words.mouth_m) answer["head_m"] = found.level_m - words.mouth_m->y();
  answer["mechanism"] = solid::mechanism_json(structure, found.at_it.mechanism);
  return answer;
}

json blocks_json(const scene::Scene& scene, const Attempt<StaticLevel>& by_blocks) {
  if (!by_blocks.value) return not_found_json(by_blocks.why_not);
  const StaticLevel& found = *by_blocks.value;
  json answer = outcome_json(found.outcome, found.level_m);
  if (found.settles_m) answer["settles_at_m"] = *found.settles_m;
  if (found.slow_rise) answer["slow_rise"] = outcome_json(found.slow_rise->outcome, found.slow_rise->level_m);
  if (found.outcome != Filled::fails) return answer;
  answer["level_width_m"] = found.width_m;
  if (!found.stopped.empty()) answer["stopped"] = found.stopped;
  if (!found.failure) return answer;
  const solid::Failure& failure = *found.failure;
  json names = json::array();
  for (const int b : failure.blocks) names.push_back(scene.blocks[at(b)].name);
  answer.update({{"mode", failure.mode},
                 {"joint", failure.joint},
                 {"turns_on", failure.turns_on},
                 {"blocks", names},
                 {"head_m", failure.head_m + (found.level_m - failure.level_m)}});
  return answer;
}

/// Of the first head of failure that the scene expects by a formula; null where there is none.
json formula_json(const scene::Scene& scene) {
  for (const scene::Expectation& e : scene.expectations) {
    if (e.quantity != "failure_head_m" || e.formula.empty()) continue;
    const double head_m = solid::expect::formula(scene, e);
    return {{"name", e.formula},
            {"joint", e.of},
            {"head_m", head_m},
            {"level_m", solid::expect::plane_joint(scene, e.of).mouth.y() + head_m}};
  }
  return nullptr;
}

/// Where the search ended, for a structure that no level of it brings down; null where one does.
json highest_json(const scene::Scene& scene, double full_m, const json& answer) {
  if (answer["outcome"] == "fails" || answer["outcome"] == "does not stand empty") return nullptr;
  return scene.water.may_overtop
             ? fmt::format("looked at up to {:.6g} m, as high above the crest as the crest is above the base", full_m)
             : fmt::format("looked at up to the crest, {:.6g} m; may_overtop = true in [water] goes on to higher ones",
                           full_m);
}

/// The water of a scene that states none; null where it does.
json assumed_json(const scene::Scene& scene) {
  if (scene.fluid != scene::FluidModel::none) return nullptr;
  const bool uplift = scene.default_joint.uplift != scene::Uplift::none ||
                      std::any_of(scene.joints.begin(), scene.joints.end(),
                                  [](const scene::Joint& joint) { return joint.law.uplift != scene::Uplift::none; });
  return fmt::format("the scene has no [water]: assumed is a reservoir of {:.4g} kg/m3 upstream without tailwater, {}",
                     scene.water.density_kg_per_m3,
                     uplift ? "with the uplift of its joints" : "and no uplift, as no joint states one");
}

/// Of the head on the joint that fails, where there is one: the rise from the empty reservoir depends on how deep the
/// scene draws the rock.
json difference_json(const FoundLevels& levels, const json& by_limit) {
  json answer = {{"reason", levels.reason()}, {"agree", levels.agree()}};
  const auto fails = [](const auto& found) { return found.value && found.value->outcome == Filled::fails; };
  if (fails(levels.blocks) && fails(levels.limit)) {
    const double less_m = levels.blocks.value->level_m - levels.limit.value->level_m;
    const double head_m = by_limit.value("head_m", 0.0);
    answer["level_m"] = less_m;
    answer["relative"] = head_m > 0 ? less_m / head_m : levels.off(*levels.blocks.value);
    answer["relative_to"] = head_m > 0 ? "head" : "rise";
  }
  return answer;
}

}  // namespace

json level_answer(const scene::Scene& scene, const FluidMaker& make_fluid) {
  constexpr double exact = 1e-10;
  StillWater water(scene, make_fluid);
  const limit::LimitAnalysis structure(scene);
  const limit::Wrenches dead =
      limit::combined(statics::weights_of(scene), 1, statics::stated_loads_of(scene, scene.analysis.duration_s));
  const auto water_at = [&](double level_m) { return statics::water_forces(scene, water.at(level_m)); };
  FoundLevels levels{.scene = scene,
                     .any_force = structure.holds_any_force(),
                     .empty_m = water.range().empty_m,
                     .limit = solid::attempt([&] { return limit_level(structure, dead, water_at, water.range()); })};
  solid::LevelClues clues;
  if (levels.limit.value) {
    clues.falls_as_drawn = levels.limit.value->outcome == Filled::does_not_stand_empty;
    if (levels.limit.value->outcome == Filled::fails) clues.limit_m = levels.limit.value->level_m;
  }
  const bool strains = solid::strains(scene);
  if (strains) {
    const scene::Scene rigid = solid::with_rigid_blocks(scene);
    clues.whose = "level by rigid blocks";
    levels.rigid = solid::attempt([&] { return solid::static_level(rigid, water, exact, clues); });
    clues.whose = solid::LevelClues{}.whose;
  }
  clues.suspect_m = levels.rigid_level();
  levels.blocks = solid::attempt([&] { return solid::static_level(scene, water, exact, clues); });
  if (!levels.limit.value && !levels.blocks.value) {
    throw std::runtime_error(levels.blocks.why_not + "; " + levels.limit.why_not);
  }
  json answer = blocks_json(scene, levels.blocks);
  answer["limit_analysis"] = limit_json(structure, levels.limit);
  solid::add_what_limit_analysis_takes(structure, answer["limit_analysis"]);
  if (strains) answer["rigid_blocks"] = blocks_json(scene, levels.rigid);
  answer["difference"] = difference_json(levels, answer["limit_analysis"]);
  answer["looked_at"] = highest_json(scene, water.range().full_m, answer);
  answer["assumed"] = assumed_json(scene);
  solid::add_water_in_an_earthquake(scene, answer);
  answer["warnings"] = water.warnings();
  solid::add_motion_left_out(scene, answer);
  solid::add_moved_supports(scene, answer);
  if (levels.blocks.value) {
    for (const std::string& warning : levels.blocks.value->warnings) answer["warnings"].push_back(warning);
  }
  if (levels.blocks.value && levels.blocks.value->outcome != Filled::does_not_stand_empty) {
    const std::string crest = solid::output::water_on_crest_warning(scene, levels.blocks.value->level_m);
    if (!crest.empty()) answer["warnings"].push_back(crest);
  }
  if (levels.blocks.value) solid::add_strain_that_lets_go(structure, water, *levels.blocks.value, answer);
  if (levels.limit.value) {
    solid::add_level_with_crushed_corners(structure, dead, water_at, water.range(), *levels.limit.value, answer);
  }
  if (const json formula = formula_json(scene); !formula.is_null()) answer["formula"] = formula;
  return answer;
}

}  // namespace blockweir::process
