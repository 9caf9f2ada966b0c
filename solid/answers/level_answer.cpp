// SPDX-License-Identifier: GPL-3.0-or-later
// The level at which a scene fails, found by the blocks' own equilibrium and by limit analysis, and what these two
// differ by.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bridge/process/answers.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/corner_stands.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/answers/crushed_corners.hpp"
#include "solid/capacity/static_level.hpp"
#include "solid/expect/formula_tables.hpp"
#include "solid/expect/formulas.hpp"
#include "solid/limit/limit_level.hpp"
#include "solid/output/water_on_crest.hpp"

namespace blockweir::process {
namespace {

using nlohmann::json;
using solid::Attempt;
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

/// The levels of one scene.
struct Levels {
  const scene::Scene& scene;
  bool any_force = false;  ///< by anchors, in limit analysis
  double empty_m = 0;
  Attempt<limit::LimitLevel> limit;
  Attempt<StaticLevel> blocks;
  Attempt<StaticLevel> rigid;  ///< of the same blocks without strain, where they strain

  /// Of a level to that of limit analysis, over the rise from the empty reservoir.
  [[nodiscard]] double off(const StaticLevel& found) const {
    return (found.level_m - limit.value->level_m) / (limit.value->level_m - empty_m);
  }
  [[nodiscard]] bool agrees(const StaticLevel& found) const {
    constexpr double same = 1e-5;  // the blocks' strain and what their slips add up to before they rest come to less
    return found.outcome == limit.value->outcome && (found.outcome != Filled::fails || std::abs(off(found)) <= same);
  }
  [[nodiscard]] std::optional<double> rigid_level() const {
    if (!rigid.value || rigid.value->outcome != Filled::fails) return std::nullopt;
    return rigid.value->level_m;
  }
  /// Do blocks that do not strain fail at a level that the blocks are said to bear?
  [[nodiscard]] bool rigid_fails_lower() const {
    constexpr double strain = 1e-3;  // effect of strain on a level, relative to the rise
    return rigid_level() && *rigid_level() < blocks.value->level_m - strain * (blocks.value->level_m - empty_m);
  }
  /// Do the blocks and limit analysis agree, and no other analysis of the blocks fails at another level?
  [[nodiscard]] bool agree() const {
    return blocks.value && limit.value && blocks.value->stopped.empty() && !blocks.value->slow_rise &&
           !rigid_fails_lower() && agrees(*blocks.value);
  }
  /// Why the blocks' level differs from that of limit analysis and from that of rigid blocks.
  [[nodiscard]] std::string reason() const {
    if (agree()) return solid::strains(scene) ? "strain, and the width of the search" : "the width of the search";
    if (!blocks.value || !limit.value) return "none is known: only one of the two has an answer";
    if (!blocks.value->stopped.empty()) return "none is known: the blocks' level is known to level_width_m alone";
    const std::string rigid_too =
        rigid_fails_lower() ? fmt::format("blocks that do not strain fail at {:.6g} m", rigid.value->level_m) : "";
    if (blocks.value->slow_rise) return of_friction_history() + (rigid_too.empty() ? "" : "; " + rigid_too);
    if (!rigid_too.empty()) {
      return "history of joint forces: the level depends on how the friction in the joints came about; " + rigid_too +
             ", the others bear more";
    }
    if (rigid.value && agrees(*rigid.value)) {
      return "deformation: blocks that do not strain fail at the level of limit analysis";
    }
    return of_an_upper_bound();
  }

 private:
  [[nodiscard]] std::string of_friction_history() const {
    const StaticLevel::SlowRise& rise = *blocks.value->slow_rise;
    return fmt::format(
        "history of joint forces: the level depends on how the friction in the joints came about; all loads at once "
        "fail at {:.6g} m, under a level that rises slowly the blocks {} {:.6g} m",
        blocks.value->level_m, rise.outcome == Filled::fails ? "fail at" : "stand up to", rise.level_m);
  }
  static std::string slips() {
    return "slips that add up to failure_displacement_m: limit analysis asks for equilibrium alone";
  }
  [[nodiscard]] std::string of_an_upper_bound() const {
    if (limit.value->outcome == Filled::does_not_stand_empty) {
      return "blocks that move before they rest: limit analysis takes the structure as it is drawn, where faces that "
             "do not touch hold nothing; no uplift acts between them, and the blocks' level is without it; let faces "
             "touch";
    }
    if (const auto stands = scene::corner_stands(scene); !stands.empty()) {
      return fmt::format(
          "block \"{}\" stands on one corner: any push turns it over, and the blocks tell a small one from none only "
          "roughly",
          scene.blocks[at(stands[0].block)].name);
    }
    const bool lower = (blocks.value->outcome == Filled::does_not_stand_empty ||
                        (blocks.value->outcome == Filled::fails && off(*blocks.value) < 0));
    // Before the slips: they add up because the anchors have not yet stretched to their yield.
    if (lower && !any_force && solid::yields_above_prestress(scene)) {
      return std::string(solid::yields_note) + (blocks.value->slips_add_up ? "; " + slips() : "");
    }
    if (lower && blocks.value->slips_add_up) {
      return slips();
    }
    if (lower && any_force) return std::string(solid::anchors_note) + "; the blocks' own bolts stretch";
    if (lower && solid::has_bonds(scene)) {
      return "history of joint forces: bonds break one after the other, and limit analysis lets all act at once";
    }
    const auto any_joint = [this](auto has) {
      const auto of = [&](const scene::Joint& joint) { return has(joint.law); };
      return has(scene.default_joint) || std::any_of(scene.joints.begin(), scene.joints.end(), of);
    };
    if (lower && any_joint([](const auto& law) { return law.has_flow(); })) {
      return "joints with uplift = \"flow\" that open and fill: limit analysis takes joints as they are drawn";
    }
    if (lower && any_joint([](const auto& law) { return law.bends(); })) {
      return "rough joints, whose friction falls with the stress: the blocks take the stress at each end of a joint, "
             "limit analysis its mean over the joint";
    }
    if (lower) {
      return "friction without dilation: limit analysis takes joints to open as they slip, and is an upper bound";
    }
    return "none is known: limit analysis is an upper bound of rigid blocks";
  }
};

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
json difference_json(const Levels& levels, const json& by_limit) {
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
  Levels levels{.scene = scene,
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
    levels.rigid = solid::attempt([&] { return solid::static_level(rigid, water, exact, clues); });
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
  if (levels.blocks.value && !levels.blocks.value->warning.empty()) {
    answer["warnings"].push_back(levels.blocks.value->warning);
  }
  if (levels.blocks.value && levels.blocks.value->outcome != Filled::does_not_stand_empty) {
    const std::string crest = solid::output::water_on_crest_warning(scene, levels.blocks.value->level_m);
    if (!crest.empty()) answer["warnings"].push_back(crest);
  }
  if (levels.limit.value) {
    solid::add_level_with_crushed_corners(structure, dead, water_at, water.range(), *levels.limit.value, answer);
  }
  if (const json formula = formula_json(scene); !formula.is_null()) answer["formula"] = formula;
  return answer;
}

}  // namespace blockweir::process
