// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/joint_answer.hpp"

#include "solid/answers/additional_water_loads.hpp"
#include "solid/answers/safety_reserves.hpp"
#include "solid/capacity/released_blocks.hpp"
#include "solid/capacity/static_blocks.hpp"
#include "solid/watch/joint_table.hpp"
#include "solid/watch/surfaces.hpp"
#include "solid/watch/uplift_in_tension.hpp"

namespace blockweir::solid {
namespace {

using limit::Bearing;
using nlohmann::json;

/// Null for a figure that is not there.
json figure(const std::optional<double>& value) {
  return value ? json(*value) : json();
}

json sums_json(const std::vector<ForceSum>& sums) {
  json all = json::array();
  for (const ForceSum& s : sums) {
    all.push_back({{"name", s.name}, {"x_n_per_m", s.force.x()}, {"y_n_per_m", s.force.y()}, {"moment_n", s.moment_n}});
  }
  return all;
}

json table_json(const std::vector<JointRow>& rows) {
  json table = json::array();
  for (const JointRow& row : rows) {
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

json bolts_json(const Solid& blocks) {
  json list = json::array();
  for (std::size_t i = 0; i < blocks.bolts().size(); ++i) {
    list.push_back(
        {{"name", blocks.scene().bolts[i].name}, {"force_n_per_m", blocks.bolts()[i].acting.tension_n_per_m}});
  }
  return list;
}

/// Loads on a structure that no strength holds: no internal forces balance them.
void add_loads(Situation& now, const process::FluidMaker& make_fluid, json& answer) {
  SearchBudget effort("loads on joints");
  StaticBlocks blocks(now.scene, now.water_if_any(), effort);
  const auto parts = now.water ? additional_water_loads(now.scene, make_fluid, now.level_m) : std::vector<WaterPart>{};
  json rows = json::array();
  for (const JointRow& row : loads_on_joints(blocks.solid(), blocks.pressures(now.level_m), parts)) {
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
void take_stated_strength(double reduction, std::vector<JointRow>& rows) {
  for (JointRow& row : rows) {
    for (std::optional<double>* factor : {&row.sliding_factor, &row.residual_sliding_factor}) {
      if (*factor) **factor *= reduction;
    }
  }
}

/// Of the mechanism's joints, with the strength as stated.
std::vector<JointPart> joint_parts_of(const Solid& blocks, const wire::Load& water, double reduction,
                                      const json& answer) {
  if (!answer.contains("mechanism")) return {};
  std::vector<JointPart> parts = joint_parts(blocks, water, answer["mechanism"]["joints"]);
  for (JointPart& part : parts) part.strength_n_per_m *= reduction;
  return parts;
}

json parts_json(const std::vector<JointPart>& parts) {
  json table = json::array();
  for (const JointPart& part : parts) {
    table.push_back({{"name", part.name},
                     {"length_m", part.length_m},
                     {"normal_n_per_m", part.normal_n_per_m},
                     {"shear_n_per_m", part.shear_n_per_m},
                     {"uplift_n_per_m", part.uplift_n_per_m},
                     {"strength_n_per_m", part.strength_n_per_m}});
  }
  return table;
}

/// What the joints of blocks at rest bear, with strength divided by `reduction`.
void add_forces(const std::vector<WaterPart>& parts, const Solid& blocks, const wire::Load& water, double reduction,
                json& answer) {
  std::vector<JointRow> table = joint_table(blocks, water, parts);
  take_stated_strength(reduction, table);
  answer["joints"] = table_json(table);
  answer["joint_parts"] = parts_json(joint_parts_of(blocks, water, reduction, answer));
  answer["bent_joints"] = bent_joints(blocks);
  answer["bolts"] = bolts_json(blocks);
  for (std::string& warning :
       uplift_warnings(blocks.scene(), {water.upstream_level_m, water.downstream_level_m}, table))
    answer["warnings"].push_back(std::move(warning));
}

}  // namespace

void add_joints(Situation& now, const process::FluidMaker& make_fluid, const StaticStrength& found, json& answer) {
  constexpr double just_stands = 1 - 1e-6;
  if (found.bearing == Bearing::bears_none) return add_loads(now, make_fluid, answer);
  const bool stands = found.bearing == Bearing::bears_any || found.factor >= 1;
  const double bearable = found.by_motion ? found.factor - found.width / 2 : found.factor * just_stands;
  const double reduction = stands ? 1 : bearable;
  const scene::Scene scene = with_reduced_strength(now.scene, reduction);
  SearchBudget effort("forces on joints");
  const auto add_if = [&](bool at_rest, auto& blocks) {
    if (!at_rest) return;
    const auto parts = now.water ? additional_water_loads(scene, make_fluid, now.level_m) : std::vector<WaterPart>{};
    const wire::Load water = blocks.pressures(now.level_m);
    add_forces(parts, blocks.solid(), water, reduction, answer);
    if (!stands) answer["joints_with_strength_times"] = 1 / reduction;
    if (stands) add_cracked_joints(blocks.solid(), now, answer);
  };
  if (found.by_motion) {
    ReleasedBlocks blocks(scene, now.water_if_any(), effort);
    add_if(blocks.come_to_rest(now.level_m), blocks);
  } else {
    StaticBlocks blocks(scene, now.water_if_any(), effort);
    add_if(blocks.begin(now.level_m), blocks);
  }
}

}  // namespace blockweir::solid
