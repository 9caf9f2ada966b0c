// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/answers.hpp"

namespace blockweir::scene {

const std::vector<std::string>& quantity_names() {
  static const std::vector<std::string> names = {
      "failure_level_m",
      "failure_head_m",
      "failure_time_s",
      "displacement_m",
      "acceleration_m_per_s2",
      "reaction_n_per_m",
      "joint_force_n_per_m",
      "stress_xx_pa",
      "stress_yy_pa",
      "stress_xy_pa",
      "shortening_m",
      "water_force_x_n_per_m",
      "water_moment_n",
      "water_pressure_pa",
      "largest_penetration_m",
      "kinetic_energy_j_per_m",
      "energy_gain",
      "area_error",
      "bolt_force_n_per_m",
      "bolt_elongation_m",
      "hinges",
      "decay_per_step",
      "oscillation_period_s",
      "oscillation_damping_ratio",
      "rebound_ratio",
      "rocking_period_s",
      "impact_ratio",
      "late_speed_m_per_s",
      "wave_speed_m_per_s",
      "slip_over_balance",
      "angular_momentum_error",
      "point_displacement_x_m",
      "point_displacement_y_m",
      "point_stress_xx_pa",
      "point_stress_yy_pa",
      "point_stress_xy_pa",
      "mode",
      "stability",
  };
  return names;
}

const std::vector<std::string>& formula_names() {
  static const std::vector<std::string> names = {
      "weight-of-all",
      "weight-above",
      "own-weight-stress",
      "own-weight-shortening",
      "plane-crack-sliding",
      "plane-crack-acceleration",
      "monolith-sliding",
      "monolith-overturning",
      "hydrostatic-force",
      "hydrostatic-moment",
      "mouth-pressure",
      "contact-decay-per-step",
      "contact-period",
      "contact-damping-ratio",
      "contact-rebound-ratio",
      "rocking-period",
      "rocking-impact-ratio",
      "bar-wave-speed",
      "bar-particle-speed",
      "bar-free-end-speed",
      "column-displacement",
      "column-period",
      "turned-stress-xx",
      "turned-stress-yy",
      "turned-stress-xy",
      "arch-thickness",
      "incline-displacement",
      "pushed-displacement",
      "shaken-incline-displacement",
      "toppling-slope-friction",
      "cantilever-deflection",
      "cantilever-stress",
      "gravity-method-stress",
      "slide-or-topple",
      "schedule-stability",
  };
  return names;
}

}  // namespace blockweir::scene
