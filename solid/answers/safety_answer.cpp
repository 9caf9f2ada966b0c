// SPDX-License-Identifier: GPL-3.0-or-later
// The factor on strength by which a scene fails, found by the blocks' own equilibrium and by limit analysis, and the
// forces on its joints.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "bridge/process/answers.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/answers/additional_water_loads.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/answers/contradiction.hpp"
#include "solid/answers/crushed_corners.hpp"
#include "solid/answers/safety_reserves.hpp"
#include "solid/answers/water_by_kind.hpp"
#include "solid/capacity/situation.hpp"
#include "solid/capacity/static_blocks.hpp"
#include "solid/capacity/static_strength.hpp"
#include "solid/limit/determinacy.hpp"
#include "solid/limit/limit_strength.hpp"
#include "solid/output/water_on_crest.hpp"
#include "solid/watch/joint_table.hpp"
#include "solid/watch/surfaces.hpp"
#include "solid/watch/uplift_in_tension.hpp"

namespace blockweir::process {
namespace {

using nlohmann::json;
using solid::Attempt;
using solid::Situation;
using solid::StaticStrength;
using solid::limit::Bearing;
namespace limit = solid::limit;

/// Null for a figure that is not there.
json figure(const std::optional<double>& value) {
  return value ? json(*value) : json();
}

json sums_json(const std::vector<solid::ForceSum>& sums) {
  json all = json::array();
  for (const solid::ForceSum& s : sums) {
    all.push_back({{"name", s.name}, {"x_n_per_m", s.force.x()}, {"y_n_per_m", s.force.y()}, {"moment_n", s.moment_n}});
  }
  return all;
}

json table_json(const std::vector<solid::JointRow>& rows) {
  json table = json::array();
  for (const solid::JointRow& row : rows) {
    table.push_back({{"name", row.name},
                     {"length_m", row.length_m},
                     {"normal_n_per_m", row.normal_n_per_m},
                     {"shear_n_per_m", row.shear_n_per_m},
                     {"uplift_n_per_m", row.uplift_n_per_m},
                     {"moment_n", row.moment_n},
                     {"sliding_factor", figure(row.sliding_factor)},
                     {"residual_sliding_factor", figure(row.residual_sliding_factor)},
                     {"resultant_from_downstream", figure(row.resultant_from_downstream)},
                     {"compressed_length_m", row.faces_length_m - row.cracked_length_m},
                     {"cracked_length_m", row.cracked_length_m},
                     {"bonded_length_m", figure(row.bonded_length_m)},
                     {"heel_stress_pa", row.heel_stress_pa},
                     {"toe_stress_pa", row.toe_stress_pa},
                     {"upstream_end_m", {row.upstream_end_m.x(), row.upstream_end_m.y()}},
                     {"downstream_end_m", {row.downstream_end_m.x(), row.downstream_end_m.y()}},
                     {"sums", sums_json(row.sums)}});
  }
  return table;
}

json bolts_json(const solid::Solid& blocks) {
  json list = json::array();
  for (std::size_t i = 0; i < blocks.bolts().size(); ++i) {
    list.push_back(
        {{"name", blocks.scene().bolts[i].name}, {"force_n_per_m", blocks.bolts()[i].acting.tension_n_per_m}});
  }
  return list;
}

/// Loads on a structure that no strength holds: no internal forces balance them.
void add_loads(Situation& now, const FluidMaker& make_fluid, json& answer) {
  solid::SearchBudget effort("loads on joints");
  solid::StaticBlocks blocks(now.scene, now.water_if_any(), effort);
  const auto parts =
      now.water ? solid::additional_water_loads(now.scene, make_fluid, now.level_m) : std::vector<solid::WaterPart>{};
  json rows = json::array();
  for (const solid::JointRow& row : solid::loads_on_joints(blocks.solid(), blocks.pressures(now.level_m), parts)) {
    rows.push_back({{"name", row.name},
                    {"length_m", row.length_m},
                    {"downstream_end_m", {row.downstream_end_m.x(), row.downstream_end_m.y()}},
                    {"sums", sums_json(row.sums)}});
  }
  answer["loads_on_joints"] = rows;
  answer["why_no_joints"] =
      "whatever the strength of the joints, the blocks find no rest: no forces in joints and anchors balance what acts "
      "on the structure; below is what acts on all that stands on each joint";
}

/// Strength over shear is that of the scene's own strength, of which `rows` have `1 / reduction` times.
void take_stated_strength(double reduction, std::vector<solid::JointRow>& rows) {
  for (solid::JointRow& row : rows) {
    for (std::optional<double>* factor : {&row.sliding_factor, &row.residual_sliding_factor}) {
      if (*factor) **factor *= reduction;
    }
  }
}

/// Joint forces of the structure as stated; if it fails, with the strength at which it would just stand.
void add_joints(Situation& now, const FluidMaker& make_fluid, const StaticStrength& found, json& answer) {
  constexpr double just_stands = 1 - 1e-6;
  if (found.bearing == Bearing::bears_none) return add_loads(now, make_fluid, answer);
  const bool stands = found.bearing == Bearing::bears_any || found.factor >= 1;
  const double reduction = stands ? 1 : found.factor * just_stands;
  const scene::Scene scene = solid::with_reduced_strength(now.scene, reduction);
  solid::SearchBudget effort("forces on joints");
  solid::StaticBlocks blocks(scene, now.water_if_any(), effort);
  if (!blocks.begin(now.level_m)) return;
  const auto parts =
      now.water ? solid::additional_water_loads(scene, make_fluid, now.level_m) : std::vector<solid::WaterPart>{};
  std::vector<solid::JointRow> table = solid::joint_table(blocks.solid(), blocks.pressures(now.level_m), parts);
  take_stated_strength(reduction, table);
  answer["joints"] = table_json(table);
  answer["bent_joints"] = solid::bent_joints(blocks.solid());
  answer["bolts"] = bolts_json(blocks.solid());
  if (!stands) answer["joints_with_strength_times"] = 1 / reduction;
  for (std::string& warning : solid::uplift_warnings(scene, now.level_m, table))
    answer["warnings"].push_back(std::move(warning));
  if (stands) solid::add_cracked_joints(blocks.solid(), now, answer);
}

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
  if (blocks.bearing != Bearing::fails_at_a_factor || (blocks.factor > *below && !blocks.creeps)) return;
  if (blocks.factor > bound.factor * (1 - next_to_nothing)) return;
  if (limit::each_joint_divides(structure.scene(), structure.faces())) {
    answer["friction_history"] = fmt::format(
        "the bond of a joint breaks from its most stressed end on, which the blocks follow, down to {:.4g}; limit "
        "analysis, with {:.4g}, has all of the bond at once",
        blocks.factor, bound.factor);
    return;
  }
  answer["friction_history"] = fmt::format(
      "with strength over {:.4g} to {:.4g} some forces in the joints hold the structure and others do not; which come "
      "about depends on how it was loaded, so that the blocks' factor may jump between these from one level to the "
      "next",
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
  answer["bent_joints"] = json::array();
  answer["bolts"] = json::array();
  answer["water"] = now.water ? solid::water_by_kind(scene, make_fluid, now.level_m) : json::array();
  answer["warnings"] = warnings_of_water(now);
  solid::add_motion_left_out(scene, answer);
  if (by_limit.value && blocks.value) {
    solid::add_contradiction(*blocks.value, *by_limit.value, answer);
    add_what_is_above_the_bound(*blocks.value, *by_limit.value, answer);
    add_friction_history(structure, *blocks.value, *by_limit.value, answer);
    solid::add_rigid_blocks(structure, now, *blocks.value, jumps_below(structure, *by_limit.value), answer);
    solid::add_brittle_bonds(structure, now, *blocks.value, limit::combined(dead, 1, stated), answer);
  }
  if (by_limit.value) solid::add_water_factor(structure, now, stated, *by_limit.value, answer);
  if (blocks.value) solid::add_stretch_of_anchors(now, *blocks.value, answer);
  if (by_limit.value) {
    solid::add_strength_with_crushed_corners(structure, limit::combined(dead, 1, stated), *by_limit.value, answer);
  }
  const bool as_drawn = answer["outcome"] != "not found" || !answer.contains("contradiction");
  if (blocks.value && as_drawn)
    solid::attempt([&] { return add_joints(now, make_fluid, *blocks.value, answer), true; });
  return answer;
}

json water_answer(const scene::Scene& scene, const FluidMaker& make_fluid) {
  Situation now(scene, make_fluid);
  return now.water ? solid::water_by_kind(scene, make_fluid, now.level_m) : json::array();
}

}  // namespace blockweir::process
