// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of a step: what loads give goes into strain, springs and motion. Contacts and damping only take.
#pragma once

#include <vector>

#include "solid/step/island_equations.hpp"
#include "solid/step/step_islands.hpp"

namespace blockweir::solid {

class StepEnergy : StepPart {
 public:
  explicit StepEnergy(StepWorkspace& step) : StepPart(step) {}

  /// The base has moved so far in the step, and pushes what is awake.
  void lead(const StepIslands& islands, const Point& moved);
  [[nodiscard]] const std::vector<Point>& pushes() const { return pushes_; }  ///< on each block, as the step ends
  /// An impulse of what moves with the base, which ends the step at its velocity, has changed a block's from this one.
  void give_by_base(std::size_t b, const Vector6& velocity_before) const;
  /// What loads give an island's blocks in the step, less what strain, bolts and springs take up.
  void balance(IslandEquations& island, double dt);
  /// What a step has made of nothing is taken back from the velocities. Contact forces act along the directions of the
  /// step's end, and points turn on their way there: a block that topples would gain by an error of the step's first
  /// order. Where nothing anchors a group its momenta stay. Most steps make nothing: then nothing is grouped.
  /// On a base that moves the motion is that against the base: what it holds rests.
  void take_back(IslandEquations& island);
  /// Or is more to be taken than all motion that is left?
  [[nodiscard]] bool affords(const IslandEquations& island) const;

 private:
  struct Group;
  /// What a block's motion has gained beyond what there was for it [J per metre].
  struct Made {
    double energy = 0;
    double round_off = 0;
    double kinetic = 0;
  };
  [[nodiscard]] Made made_by(std::size_t b) const;
  [[nodiscard]] Vector6 with_base(std::size_t b) const;
  [[nodiscard]] Point push_of_base(std::size_t b, const Vector6& load, double dt) const;
  [[nodiscard]] std::vector<Group> makers(const IslandEquations& island, std::vector<int>& group_of) const;
  [[nodiscard]] Eigen::Matrix<double, 6, 3> rigid_of(const IslandEquations& island, const std::vector<int>& group_of,
                                                     std::size_t block) const;
  void look_at_links(const IslandEquations& island, const std::vector<int>& group_of, std::vector<Group>& groups) const;

  std::vector<Point> pushes_;    ///< of a base that moves, on each block as the step ends; none where it rests
  std::vector<bool> on_base_;    ///< blocks whose island touches what moves with the base
  Point moved_ = Point::Zero();  ///< by the base in the step [m]
};

}  // namespace blockweir::solid
