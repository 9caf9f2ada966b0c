// SPDX-License-Identifier: GPL-3.0-or-later
// The energy balance of a step: loads supply strain, spring and kinetic energy; contacts and damping only dissipate.
#pragma once

#include <vector>

#include "solid/step/island_equations.hpp"
#include "solid/step/step_islands.hpp"

namespace blockweir::solid {

class StepEnergy : StepPart {
 public:
  explicit StepEnergy(StepWorkspace& step) : StepPart(step) {}

  /// Displacement of the base in the step, and its forces on the awake blocks.
  void lead(const StepIslands& islands, const Point& moved);
  [[nodiscard]] const std::vector<Point>& pushes() const { return pushes_; }  ///< on each block, at the step's end
  /// Gives and returns the work of what goes at `velocity` when an impulse of it has changed a block's from `before`.
  double give_by_carrier(std::size_t b, const Point& velocity, const Vector6& before) const;
  /// What else gives a block energy for its motion [J per metre].
  void give(std::size_t b, double work) const;
  /// Work of loads on an island's blocks in the step, less the energy taken by strain, bolts and springs.
  void balance(IslandEquations& island, double dt);
  /// Removes spurious energy of the step from the velocities. Contact forces act along the directions at the step's
  /// end, while points turn during the step: a toppling block would gain energy by this first-order error. Free groups
  /// keep their momenta. Most steps produce none, and then no groups are formed. Velocities are relative
  /// to a moving base, or to supports that lead all that holds a group, so that what they carry stays at rest.
  void take_back(IslandEquations& island);
  /// Whether the kinetic energy is sufficient for the removal.
  [[nodiscard]] bool affords(const IslandEquations& island) const;

 private:
  struct Group;
  /// Kinetic energy of a block that no work accounts for [J per metre].
  struct Made {
    double energy = 0;
    double round_off = 0;
  };
  [[nodiscard]] Made made_by(std::size_t b) const;
  [[nodiscard]] Vector6 going_at(std::size_t b, const Point& velocity) const;
  [[nodiscard]] Point carrier_of(const Group& group) const;
  void give_by_support(int k, double dt) const;
  [[nodiscard]] Point push_of_base(std::size_t b, const Vector6& load, double dt) const;
  [[nodiscard]] std::vector<Group> makers(const IslandEquations& island, std::vector<int>& group_of) const;
  [[nodiscard]] Eigen::Matrix<double, 6, 3> rigid_of(const IslandEquations& island, const std::vector<int>& group_of,
                                                     std::size_t block) const;
  void pass_debts_on(const IslandEquations& island, const std::vector<int>& group_of, std::vector<Group>& groups) const;
  void look_at_links(const IslandEquations& island, const std::vector<int>& group_of, std::vector<Group>& groups) const;

  std::vector<Point> pushes_;    ///< force of a moving base on each block at the end of the step; empty without one
  std::vector<bool> on_base_;    ///< blocks whose island touches something that moves with the base
  Point moved_ = Point::Zero();  ///< displacement of the base in the step [m]
};

}  // namespace blockweir::solid
