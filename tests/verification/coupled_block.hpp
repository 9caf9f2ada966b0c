// SPDX-License-Identifier: GPL-3.0-or-later
// One block, and water that answers its acceleration one window late.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/verification/scenes.hpp"

namespace blockweir::solid {

inline constexpr double width_m = 1;
inline constexpr double height_m = 2;
inline constexpr double mass = 2500 * width_m * height_m;
inline constexpr double window_s = 0.01;

/// What the block is made of must not matter to its rigid motion.
enum class Kind { rigid, deformable, meshed };

inline std::string name_of(Kind kind) {
  return kind == Kind::rigid ? "rigid" : kind == Kind::deformable ? "deformable" : "meshed";
}

/// One block about the origin, weightless.
inline scene::Scene free_block(Kind kind, scene::Integrator integrator, int steps_per_window = 1) {
  auto scene = empty_scene();
  scene.analysis.gravity_m_per_s2 = 0;
  scene.analysis.integrator = integrator;
  scene.analysis.step_s = window_s / steps_per_window;
  scene.analysis.max_displacement_ratio = 1;
  const double x = width_m / 2;
  const double y = height_m / 2;
  add(scene, {{-x, -y}, {x, -y}, {x, y}, {-x, y}});
  scene.blocks[0].rigid = kind == Kind::rigid;
  scene.blocks[0].mesh_size_m = kind == Kind::meshed ? 0.5 : 0;
  return scene;
}

/// A push at the centroid to the right.
inline void push(scene::Scene& scene, double force_n_per_m) {
  scene::PointLoad load{.block = 0, .point_m = Point(0, 0)};
  load.force_x_n_per_m = scene::TimeTable::constant(force_n_per_m);
  load.force_y_n_per_m = scene::TimeTable::constant(0);
  scene.point_loads.push_back(load);
}

/// A spring at the centroid, so long that it hardly turns.
inline void spring(scene::Scene& scene, double stiffness_n_per_m2) {
  scene.bolts.push_back({.name = "spring",
                         .blocks = {0, -1},
                         .from_m = Point(0, 0),
                         .to_m = Point(-1000, 0),
                         .stiffness_n_per_m2 = stiffness_n_per_m2,
                         .yield_n_per_m = {},
                         .takes_compression = true});
}

/// On x and rotation: what pressures on the left face can exert.
inline Eigen::Matrix3d added(double xx, double xr = 0, double rr = 0) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  m(0, 0) = xx;
  m(0, 2) = m(2, 0) = xr;
  m(2, 2) = rr;
  return m;
}

/// How the water measures the acceleration of a window.
enum class Seen { velocities, positions };

/// -M_a a of the window before, as pressures on the left face.
class AnsweringWater {
 public:
  AnsweringWater(const Eigen::Matrix3d& inertia, Seen seen) : inertia_(inertia), seen_(seen) {}

  std::vector<Panel> answer(const Solid& solid) {
    const BlockState& now = solid.states()[0];
    Eigen::Vector3d speed = now.velocity.head<3>();
    if (begun_ && seen_ == Seen::positions) speed = (now.displacement.head<3>() - place_) / window_s;
    const Eigen::Vector3d change = begun_ ? Eigen::Vector3d(speed - speed_) : Eigen::Vector3d::Zero();
    const Eigen::Vector3d force = -inertia_ * change / window_s;
    speed_ = speed;
    place_ = now.displacement.head<3>();
    begun_ = true;
    const double mean = force[0] / height_m;
    const double slope = -force[2] * 6 / (height_m * height_m);
    return {{.block = 0,
             .edge = 3,
             .s_from = 0,
             .s_to = 1,
             .pressure_from_pa = mean + slope,
             .pressure_to_pa = mean - slope}};
  }

 private:
  Eigen::Matrix3d inertia_;
  Seen seen_;
  bool begun_ = false;
  Eigen::Vector3d speed_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
};

struct Coupled {
  const scene::Scene& scene;
  Eigen::Matrix3d inertia;  ///< of the water
  double guess = 1;         ///< of it, that the guard has; 0: no guard
  Seen seen = Seen::velocities;
};

/// Displacement (u0, v0, r0) after each window.
inline std::vector<Eigen::Vector3d> course(const Coupled& run, int windows) {
  Solid solid(run.scene);
  AnsweringWater water(run.inertia, run.seen);
  std::vector<Eigen::Vector3d> places{Eigen::Vector3d::Zero()};
  for (int n = 0; n < windows; ++n) {
    const auto panels = water.answer(solid);
    const AddedMasses masses = run.guess > 0 ? AddedMasses{run.guess * run.inertia} : AddedMasses{};
    solid.advance(n * window_s, (n + 1) * window_s, panels, masses);
    places.emplace_back(solid.states()[0].displacement.head<3>());
  }
  return places;
}

inline const std::vector<scene::Integrator> integrators{scene::Integrator::shi, scene::Integrator::trapezoidal,
                                                        scene::Integrator::generalized_alpha};

}  // namespace blockweir::solid
