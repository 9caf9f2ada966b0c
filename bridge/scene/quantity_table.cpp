// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/quantity_table.hpp"

#include <algorithm>

namespace blockweir::scene {
namespace {

constexpr bool takes_a_point = true;
constexpr bool says_a_word = true;
constexpr bool of_one_block = true;

constexpr QuantityEntry all_quantities[] = {
    // Of the first failure; `of` says which block or joint is expected to be it.
    {"failure_level_m", Subject::block_if_any},
    {"failure_head_m", Subject::block_if_any},
    {"failure_time_s", Subject::block_if_any},
    {"displacement_m", Subject::block},
    {"acceleration_m_per_s2", Subject::block},
    {"reaction_n_per_m", Subject::block},
    {"joint_force_n_per_m", Subject::joint},
    {"stress_xx_pa", Subject::block},
    {"stress_yy_pa", Subject::block},
    {"stress_xy_pa", Subject::block},
    {"shortening_m", Subject::block},
    {"water_force_x_n_per_m", Subject::block, Need::water},
    {"water_moment_n", Subject::block, Need::water},
    {"water_pressure_pa", Subject::block, Need::water},
    {"largest_penetration_m"},
    {"kinetic_energy_j_per_m"},
    {"energy_gain"},
    {"area_error", Subject::block},
    {"bolt_force_n_per_m", Subject::bolt},
    {"bolt_elongation_m", Subject::bolt},
    {"hinges", Subject::arch},
    {"pile_width_m"},
    {"pile_height_m"},
    {"decay_per_step", Subject::block},
    {"oscillation_period_s", Subject::block},
    {"oscillation_damping_ratio", Subject::block},
    {"rebound_ratio", Subject::block},
    {"rocking_period_s", Subject::block},
    {"impact_ratio", Subject::block},
    {"late_speed_m_per_s", Subject::block},
    {"wave_speed_m_per_s", Subject::block, Need::face_pressure},
    {"slip_over_balance", Subject::joint, Need::water},
    {"angular_momentum_error", Subject::block},
    {"point_displacement_x_m", Subject::block, Need::nothing, takes_a_point},
    {"point_displacement_y_m", Subject::block, Need::nothing, takes_a_point},
    {"point_stress_xx_pa", Subject::block, Need::nothing, takes_a_point},
    {"point_stress_yy_pa", Subject::block, Need::nothing, takes_a_point},
    {"point_stress_xy_pa", Subject::block, Need::nothing, takes_a_point},
    {"mode", Subject::block_if_any, Need::nothing, !takes_a_point, says_a_word},
    {"invariants", Subject::none, Need::nothing, !takes_a_point, says_a_word},
    {"stability", Subject::block_if_any, Need::water, !takes_a_point, says_a_word},
};

constexpr QuantityEntry all_formulas[] = {
    {"weight-of-all"},
    {"weight-above", Subject::joint},
    {"own-weight-stress", Subject::block_only},
    {"own-weight-shortening", Subject::block_only},
    {"plane-crack-sliding", Subject::joint, Need::nothing, !takes_a_point, !says_a_word, of_one_block},
    {"plane-crack-acceleration", Subject::joint, Need::upstream_level, !takes_a_point, !says_a_word, of_one_block},
    {"monolith-sliding", Subject::joint, Need::nothing, !takes_a_point, !says_a_word, of_one_block},
    {"monolith-overturning", Subject::joint, Need::nothing, !takes_a_point, !says_a_word, of_one_block},
    {"cracked-through", Subject::joint, Need::nothing, !takes_a_point, !says_a_word, of_one_block},
    {"hydrostatic-force", Subject::block_only, Need::upstream_level},
    {"hydrostatic-moment", Subject::block_only, Need::upstream_level},
    {"mouth-pressure", Subject::joint, Need::upstream_level},
    {"contact-decay-per-step", Subject::block_only},
    {"contact-period", Subject::block_only},
    {"contact-damping-ratio", Subject::block_only},
    {"contact-rebound-ratio", Subject::block_only},
    {"rocking-period", Subject::block_only},
    {"rocking-impact-ratio", Subject::block_only},
    {"bar-wave-speed", Subject::block_only},
    {"bar-particle-speed", Subject::block_only, Need::face_pressure},
    {"bar-free-end-speed", Subject::block_only, Need::face_pressure},
    {"column-displacement", Subject::block_only, Need::column},
    {"column-period", Subject::block_only, Need::column},
    {"wall-in-reservoir-period", Subject::block_only, Need::upstream_level},
    {"turned-stress-xx", Subject::block_only},
    {"turned-stress-yy", Subject::block_only},
    {"turned-stress-xy", Subject::block_only},
    {"arch-thickness", Subject::arch},
    {"incline-displacement", Subject::joint},
    {"pushed-displacement"},
    {"shaken-incline-displacement", Subject::joint},
    {"toppling-slope-friction"},
    {"cantilever-deflection", Subject::block_only, Need::nothing, takes_a_point},
    {"cantilever-stress", Subject::block_only, Need::nothing, takes_a_point},
    {"gravity-method-stress", Subject::block_only, Need::nothing, takes_a_point},
    {"slide-or-topple", Subject::joint, Need::nothing, !takes_a_point, says_a_word},
    {"schedule-stability", Subject::block_only, Need::column, !takes_a_point, says_a_word},
};

std::vector<std::string> names_of(std::span<const QuantityEntry> table) {
  std::vector<std::string> names;
  for (const QuantityEntry& entry : table) names.emplace_back(entry.name);
  return names;
}

}  // namespace

std::span<const QuantityEntry> quantities() {
  return all_quantities;
}

std::span<const QuantityEntry> formulas() {
  return all_formulas;
}

const QuantityEntry* find_entry(std::span<const QuantityEntry> table, const std::string& name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const QuantityEntry& a) { return name == a.name; });
  return found == table.end() ? nullptr : &*found;
}

std::vector<std::string> quantity_names() {
  return names_of(all_quantities);
}

std::vector<std::string> formula_names() {
  return names_of(all_formulas);
}

}  // namespace blockweir::scene
