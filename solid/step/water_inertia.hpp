// SPDX-License-Identifier: GPL-3.0-or-later
// The added-mass guard in a step. The inertia of water that one block alone pushes is added to that block's matrix. The
// other motions (WaterMotions) are v = P q', q' the velocities of blocks and mesh nodes: M_a adds P^T M_a P to the
// system matrix, as a low-rank part (low_rank.hpp). If the fluid does not respond to the bending of a mesh, the motion
// is the mean motion of its triangles.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "solid/solve/islands.hpp"
#include "solid/solve/low_rank.hpp"
#include "solid/solve/saddle_point.hpp"
#include "solid/step/step_workspace.hpp"

namespace blockweir::solid {

class IslandEquations;

/// The added mass in the water forces of a window, and the velocities that these forces respond to, with their time.
/// For dynamic analyses with the added-mass guard on.
struct Answered {
  const AddedMasses& masses;
  const std::vector<Eigen::Vector3d>& velocities;
  double time_s;
};

class WaterInertia : StepPart {
 public:
  explicit WaterInertia(StepWorkspace& step) : StepPart(step) {}

  void begin_window(const Answered& answered);
  /// Adds the force M_a a' to blocks and meshes, and computes the history term of the water's inertia.
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
  /// P^T M_a P in the step's matrix, without the part in the blocks' own matrices.
  [[nodiscard]] LowRank beside(const IslandEquations& island) const;

 private:
  /// A motion with inertia that is in no block's own matrix.
  struct Motion {
    std::size_t number = 0;
    std::vector<MotionShare> shares;
  };
  using Numbers = std::vector<Eigen::Index>;

  [[nodiscard]] Motion mean_of_mesh(std::size_t block) const;
  /// Adds the guard's force on the motion to its parts.
  void push(const Motion& motion);
  void find_masses();
  [[nodiscard]] Numbers motions_of(const IslandEquations& island) const;
  /// Values of all motions, from values of the parts (of triangles: of their corners).
  template <class OfPart>
  [[nodiscard]] Eigen::VectorXd gather(const OfPart& of_part) const;
  [[nodiscard]] Eigen::VectorXd velocities_before() const;
  [[nodiscard]] Eigen::VectorXd velocities_now() const;
  [[nodiscard]] Numbers rows_of(const IslandEquations& island) const;
  [[nodiscard]] Eigen::MatrixXd inertia(const Numbers& rows) const;

  std::vector<Motion> motions_;  ///< under the guard
  Eigen::MatrixXd masses_;       ///< M_a of the motions, three each; zero where a block's own matrix has it
  Eigen::VectorXd history_;      ///< what that inertia remembers
};

}  // namespace blockweir::solid
