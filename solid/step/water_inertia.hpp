// SPDX-License-Identifier: GPL-3.0-or-later
// The added-mass guard in a step. On a block of its own it is a few terms more of its matrix. A block with a mesh tells
// the fluid its mean motion; the water's inertia resists that motion, P velocities of the nodes, and so adds P^T M_a P
// to their matrix: of rank three, and of all nodes with each other. It is kept apart of the sparse matrix (Woodbury).
#pragma once

#include <vector>

#include "solid/solve/islands.hpp"
#include "solid/solve/saddle_point.hpp"
#include "solid/step/step.hpp"

namespace blockweir::solid {

class IslandEquations;

/// What the water that acts in a window answers: the inertia in its forces, for the added-mass guard of dynamic
/// analyses where the scene has it on, with velocities (u0, v0, r0) of the scene's blocks and the time that it was
/// told.
struct Answered {
  const AddedMasses& masses;
  const std::vector<Eigen::Vector3d>& velocities;
  double time_s;
};

class WaterInertia : StepPart {
 public:
  explicit WaterInertia(Step& step) : StepPart(step) {}

  void begin_window(const Answered& answered);
  /// The force M_a a' on blocks and meshes, and what the inertia of meshes remembers.
  void begin_step(double dt);
  [[nodiscard]] bool of_meshes() const { return !mean_motions_.empty(); }
  /// By how much the kinetic energy of the water that blocks push along has risen in the step [J per metre].
  [[nodiscard]] double taken_by_water(const IslandEquations& island) const;

  /// To the residual at nodes, and to what round-off leaves uncertain of it.
  void add_to_residual(IslandEquations& island) const;
  /// Beside unknown forces the inertia is a few more of them: f = lambda e.P d, a force a mode e of M_a that has
  /// inertia.
  void add_to_saddle(const IslandEquations& island, SaddlePoint& saddle) const;
  /// (K + U S U^T) d = r from solutions with K: d = x - X (I + S U^T X)^-1 S U^T x, x = K^-1 r, X = K^-1 U.
  void correct(const IslandEquations& island, Eigen::VectorXd& x) const;

 private:
  /// The motion (u0, v0, r0) of a block with a mesh, whose inertia in water its triangles share.
  struct MeanMotion {
    std::size_t block = 0;
    std::vector<Eigen::Matrix<double, 3, 6>> of_corners;  ///< its rates by the velocities of each triangle's corners
    Eigen::Vector3d history;                              ///< what its inertia remembers
    /// Are its triangles, all joined, in this island?
    [[nodiscard]] bool in(const Parts& parts, const Island& island) const;
  };
  void guard_mesh(std::size_t block, double dt);
  [[nodiscard]] Eigen::MatrixXd mean_motions(const IslandEquations& island, Eigen::MatrixXd& inertia) const;

  std::vector<MeanMotion> mean_motions_;  ///< of meshed blocks under the guard
};

}  // namespace blockweir::solid
