// SPDX-License-Identifier: GPL-3.0-or-later
// The added-mass guard in a step. On a block that pushes its water alone it is a few terms more of its matrix. A block
// with a mesh tells the fluid its mean motion; the water's inertia resists that motion, P velocities of the nodes. So
// the whole M_a adds P^T M_a P to the matrix, of three ranks a block and of all with each other. It is kept apart of
// the sparse matrix (Woodbury).
#pragma once

#include <Eigen/LU>
#include <vector>

#include "solid/solve/islands.hpp"
#include "solid/solve/saddle_point.hpp"
#include "solid/step/step_workspace.hpp"

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

/// (K + U S U^T)^-1 = K^-1 - X (I + S X^T U)^-1 S U^T K^-1, X = K^-1 U, of an island's matrix K.
struct WaterFactors {
  Eigen::MatrixXd U;
  Eigen::MatrixXd S;
  Eigen::MatrixXd X;
  Eigen::PartialPivLU<Eigen::MatrixXd> core;
};

class WaterInertia : StepPart {
 public:
  explicit WaterInertia(StepWorkspace& step) : StepPart(step) {}

  void begin_window(const Answered& answered);
  /// The force M_a a' on blocks and meshes, and what the water's inertia remembers.
  void begin_step(double dt);
  [[nodiscard]] bool of_meshes() const;
  /// Is there inertia beyond that of the blocks' own matrices?
  [[nodiscard]] bool couples() const { return !motions_.empty(); }
  /// By how much the kinetic energy of the water that blocks push along has risen in the step [J per metre].
  [[nodiscard]] double taken_by_water(const IslandEquations& island) const;
  /// What blocks get from each other through the water is there for their motion.
  void pass_on(const IslandEquations& island, double dt) const;

  /// To the residual at nodes, and to what round-off leaves uncertain of it; of blocks without a mesh the island's
  /// pulls.
  void add_to_residual(IslandEquations& island) const;
  /// Beside unknown forces the inertia is a few more of them: f = lambda e.P d, a force a mode e of M_a that has
  /// inertia.
  void add_to_saddle(const IslandEquations& island, SaddlePoint& saddle) const;
  /// With the matrix that the island's system has just solved with.
  [[nodiscard]] WaterFactors factors(const IslandEquations& island) const;
  /// From solutions with K to such with K + U S U^T.
  static void correct(const WaterFactors& factors, Eigen::VectorXd& x);

 private:
  /// (u0, v0, r0) of a block that shares its water with others, or has a mesh, whose inertia its triangles share.
  struct Motion {
    std::size_t block = 0;
    std::vector<Eigen::Matrix<double, 3, 6>> of_corners;  ///< its rates by the velocities of each triangle's corners
  };
  using Numbers = std::vector<Eigen::Index>;

  Motion motion_of_mesh(std::size_t block);
  void find_masses();
  [[nodiscard]] Numbers motions_of(const IslandEquations& island) const;
  /// Of each motion, by what triangles' corners or the block itself have.
  template <class OfCorners, class OfBlock>
  [[nodiscard]] Eigen::VectorXd gather(const OfCorners& of_corners, const OfBlock& of_block) const;
  [[nodiscard]] Eigen::VectorXd velocities_before() const;
  [[nodiscard]] Eigen::VectorXd velocities_now() const;
  [[nodiscard]] Eigen::MatrixXd columns(const IslandEquations& island, const Numbers& here) const;
  [[nodiscard]] Eigen::MatrixXd inertia(const Numbers& here) const;

  std::vector<Motion> motions_;  ///< under the guard
  Eigen::MatrixXd masses_;       ///< M_a of the motions, three each; zero where a block's own matrix has it
  Eigen::VectorXd history_;      ///< what that inertia remembers
};

}  // namespace blockweir::solid
