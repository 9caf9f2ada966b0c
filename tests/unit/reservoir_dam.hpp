// SPDX-License-Identifier: GPL-3.0-or-later
// A dam of two blocks on rock before 20 m of water that answers, for tests of its parts and of the whole.
#pragma once

#include <array>
#include <string>

#include "bridge/scene/read/read.hpp"
#include "fluid/reservoir/reservoir_model.hpp"

namespace blockweir::reservoir {

inline scene::Scene dam_of_two(const std::string& more = "") {
  const std::string text = R"(analysis = { duration_s = 1, rigid = "all" }
water = { upstream_level_m = 20 }
joint = { friction_angle_deg = 30, uplift = "triangular" }
material.m = { youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2400 }
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-50, -10], [80, -10], [80, 0], [-50, 0]]
[[block]]
name = "low"
material = "m"
vertices_m = [[0, 0], [16, 0], [16, 10], [0, 10]]
[[block]]
name = "top"
material = "m"
vertices_m = [[0, 10], [16, 10], [16, 22], [0, 22]]
)" + (more.empty() ? "[fluid]\nmodel = \"reservoir\"\n" : more);
  return scene::read_text(text, "dam").scene;
}

/// Both blocks move together, x along and v its rate.
inline wire::Motion moved(double x, double v) {
  wire::Motion motion;
  motion.displacement.own() = {{}, {x, 0, 0, 0, 0, 0}, {x, 0, 0, 0, 0, 0}};
  motion.velocity.own() = {{}, {v, 0, 0, 0, 0, 0}, {v, 0, 0, 0, 0, 0}};
  return motion;
}

/// Of open water on faces that look upstream.
inline double thrust(const wire::Load& load) {
  const std::array<double, 3> height{0, 10, 12};
  double sum = 0;
  for (std::size_t i = 0; i < load.cracks_from; ++i) {
    if (load.edge[i] != 3) continue;
    sum += (load.s_to[i] - load.s_from[i]) * height[load.block[i]] *
           (load.pressure_from_pa[i] + load.pressure_to_pa[i]) / 2;
  }
  return sum;
}

constexpr double still = 1000 * 9.81 * 20 * 20 / 2;
constexpr double added = 0.5427545 * 1000 * 20 * 20;

}  // namespace blockweir::reservoir
