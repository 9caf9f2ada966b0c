// SPDX-License-Identifier: GPL-3.0-or-later
// The factor on strength by which a scene fails, found by the blocks' own equilibrium and by limit analysis, and the
// forces on its joints.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bridge/process/answers.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/answer_parts.hpp"
#include "solid/limit/limit_strength.hpp"
#include "solid/static_blocks.hpp"
#include "solid/static_strength.hpp"
#include "solid/watch/joint_table.hpp"

namespace blockweir::process {
namespace {

using nlohmann::json;
using solid::StaticStrength;
using solid::StillWater;
using solid::limit::Bearing;
namespace limit = solid::limit;

/// A scene under the loads and levels of its run's end.
struct Situation {
  const scene::Scene& scene;
  std::optional<StillWater> water;
  double level_m = std::numeric_limits<double>::quiet_NaN();  ///< of the reservoir; NaN without water

  Situation(const scene::Scene& given, const FluidMaker& make_fluid) : scene(given) {
    if (scene.fluid == scene::FluidModel::none) return;
    water.emplace(scene, make_fluid);
    const auto& level = scene.water.upstream_level_m;
    level_m = level ? level->at(scene.analysis.duration_s) : water->range().empty_m;
  }
  [[nodiscard]] limit::Wrenches dead() {
    const limit::Wrenches weights = statics::weights_of(scene);
    return water ? limit::combined(weights, 1, statics::water_forces(scene, water->at(level_m))) : weights;
  }
  StillWater* water_if_any() { return water ? &*water : nullptr; }
};

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
                     {"compressed_length_m", row.length_m - row.cracked_length_m},
                     {"cracked_length_m", row.cracked_length_m},
                     {"heel_stress_pa", row.heel_stress_pa},
                     {"toe_stress_pa", row.toe_stress_pa},
                     {"downstream_end_m", {row.downstream_end_m.x(), row.downstream_end_m.y()}},
                     {"sums", sums_json(row.sums)}});
  }
  return table;
}

/// Forces on joints as the scene stands; where it does not, with just the strength with which it would.
void add_joints(Situation& now, const StaticStrength& found, json& answer) {
  constexpr double just_stands = 1 - 1e-6;
  answer["joints"] = json::array();
  if (found.bearing == Bearing::bears_none) return;
  const bool stands = found.bearing == Bearing::bears_any || found.factor >= 1;
  const double reduction = stands ? 1 : found.factor * just_stands;
  const scene::Scene scene = solid::with_reduced_strength(now.scene, reduction);
  solid::StaticBlocks blocks(scene, now.water_if_any());
  if (!blocks.begin(now.level_m)) return;
  answer["joints"] = table_json(solid::joint_table(blocks.solid(), blocks.pressures(now.level_m)));
  if (!stands) answer["joints_with_strength_times"] = 1 / reduction;
}

json factor_json(Bearing bearing, double factor) {
  return bearing == Bearing::fails_at_a_factor ? json(factor) : json();
}

const char* without_factor(Bearing bearing) {
  return bearing == Bearing::bears_any ? "no joint needs shear strength" : "no shear strength of joints would do";
}

}  // namespace

json safety_answer(const scene::Scene& scene, const FluidMaker& make_fluid) {
  Situation now(scene, make_fluid);
  const limit::LimitAnalysis structure(scene);
  const limit::Wrenches stated = statics::stated_loads_of(scene, scene.analysis.duration_s);
  const limit::Wrenches dead = now.dead();
  const limit::LimitStrength by_limit = limit::limit_strength(structure, limit::combined(dead, 1, stated));
  const double guess = by_limit.bearing == Bearing::fails_at_a_factor ? by_limit.factor : 1;
  const StaticStrength blocks = solid::static_strength(scene, now.water_if_any(), now.level_m, guess);
  const bool stands =
      blocks.bearing == Bearing::bears_any || (blocks.bearing != Bearing::bears_none && blocks.factor >= 1);
  json answer = {{"outcome", stands ? "stands" : "fails"},
                 {"level_m", std::isnan(now.level_m) ? json() : json(now.level_m)},
                 {"factor", factor_json(blocks.bearing, blocks.factor)},
                 {"factor_width", blocks.width},
                 {"limit_analysis_factor", factor_json(by_limit.bearing, by_limit.factor)}};
  if (blocks.bearing != Bearing::fails_at_a_factor) answer["why_no_factor"] = without_factor(blocks.bearing);
  if (by_limit.bearing == Bearing::fails_at_a_factor) {
    answer["gap"] = by_limit.gap;
    answer["mechanism"] = solid::mechanism_json(structure, by_limit.mechanism);
  } else {
    answer["why_no_limit_analysis_factor"] = without_factor(by_limit.bearing);
  }
  const limit::LargestFactor loads = structure.largest_factor(dead, stated);
  if (loads.bearing == Bearing::fails_at_a_factor) {
    answer["load_factor"] = {
        {"factor", loads.factor}, {"gap", loads.gap}, {"mechanism", solid::mechanism_json(structure, loads.mechanism)}};
  }
  solid::add_water_in_an_earthquake(scene, answer);
  add_joints(now, blocks, answer);
  return answer;
}

}  // namespace blockweir::process
