// SPDX-License-Identifier: GPL-3.0-or-later
// A wall that is glued to rock swings before a reservoir: its frequency, and what becomes of its kinetic energy.
#pragma once

#include <fmt/format.h>

#include <numbers>

#include "bridge/process/answers.hpp"
#include "bridge/scene/read/read.hpp"
#include "solid/watch/energy.hpp"
#include "tests/verification/blocks_and_reservoir.hpp"

namespace blockweir::solid {

struct Wall {
  const char* schedule = "serial";
  const char* integrator = "trapezoidal";
  double mesh_size_m = 4;  ///< 0: it strains evenly
  double density_kg_per_m3 = 2400;
  double step_s = 0.002;
  std::string water{};  ///< keys of the reservoir
  double duration_s = 2.4;
};

/// 40 m high and 6 m thick, glued to rock; its crest is pushed from the start on.
inline std::string text_of(const Wall& wall) {
  return fmt::format(R"(coupling = {{ schedule = "{}", window_s = {} }}
water = {{ upstream_level_m = 38 }}
fluid = {{ model = "reservoir", reservoir = {{ {} }} }}
material.m = {{ youngs_modulus_pa = 25e9, poissons_ratio = 0.2, density_kg_per_m3 = {} }}
joint = {{ friction_angle_deg = 45, cohesion_pa = 1e9, tension_strength_pa = 1e9 }}
point_load = [ {{ block = "wall", point_m = [6, 40], force_n_per_m = [1e4, 0] }} ]
[analysis]
duration_s = {}
step_s = {}
gravity_m_per_s2 = 0
start = "unstressed"
integrator = "{}"
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-30, -10], [50, -10], [50, 0], [-30, 0]]
[[block]]
name = "wall"
material = "m"
{}
vertices_m = [[0, 0], [6, 0], [6, 40], [0, 40]]
)",
                     wall.schedule, wall.step_s, wall.water, wall.density_kg_per_m3, wall.duration_s, wall.step_s,
                     wall.integrator, wall.mesh_size_m > 0 ? fmt::format("mesh_size_m = {}", wall.mesh_size_m) : "");
}

inline double wet_frequency(const Wall& wall) {
  const auto answer =
      process::modes_answer(scene::read_text(text_of(wall), "wall").scene, hydrostatic::make, reservoir::mass_on_faces);
  return answer["wet"][0]["omega_rad_per_s"].get<double>();
}

/// Mean motion of the wall along x, and its kinetic energy, after each window.
class Recorded : public Blocks {
 public:
  using Blocks::Blocks;
  void record() override {
    moved.push_back(solid.states()[1].displacement[0]);
    kinetic.push_back(energy_of(solid).kinetic);
  }
  std::vector<double> moved;
  std::vector<double> kinetic;
};

struct Swing {
  double omega;
  double growth;  ///< of the kinetic energy
};

/// What is left of the motion beside the best c0 + c1 cos(w t) + c2 sin(w t).
inline double left_beside(double omega, const std::vector<double>& moved, double step_s) {
  Eigen::MatrixX3d terms(static_cast<Eigen::Index>(moved.size()), 3);
  for (Eigen::Index i = 0; i < terms.rows(); ++i) {
    const double phase = omega * step_s * static_cast<double>(i);
    terms.row(i) << 1, std::cos(phase), std::sin(phase);
  }
  const auto y = Eigen::Map<const Eigen::VectorXd>(moved.data(), terms.rows());
  return (y - terms * terms.householderQr().solve(y)).norm();
}

/// Largest of the second half over that of the first.
inline double growth_of(const std::vector<double>& kinetic) {
  const auto half = static_cast<std::ptrdiff_t>(kinetic.size() / 2);
  return *std::max_element(kinetic.end() - half, kinetic.end()) /
         *std::max_element(kinetic.begin(), kinetic.begin() + half);
}

inline Swing swing_of(const Wall& wall, double near) {
  const scene::Scene scene = scene::read_text(text_of(wall), "wall").scene;
  Recorded blocks(scene);
  run_with_reservoir(scene, blocks);
  Swing swing{near, 0};
  double least = std::numeric_limits<double>::infinity();
  for (double omega = 0.95 * near; omega < 1.05 * near; omega += 1e-4 * near) {
    const double left = left_beside(omega, blocks.moved, wall.step_s);
    if (left < least) least = left, swing.omega = omega;
  }
  swing.growth = growth_of(blocks.kinetic);
  return swing;
}

}  // namespace blockweir::solid
