// SPDX-License-Identifier: GPL-3.0-or-later
// What overlaps as a step ends is pushed apart by displacements alone: closed within a step, an overlap would become a
// velocity. Pushes have no friction and move each block as a rigid one, the light ones farther than the heavy: of all
// displacements that leave no overlap those that move least mass (0 <= gap _|_ push >= 0).
#pragma once

#include "solid/step/island_equations.hpp"
#include "solid/step/meetings.hpp"

namespace blockweir::solid {

class PushApart : StepPart {
 public:
  explicit PushApart(StepWorkspace& step) : StepPart(step), now_(step) {}

  /// Of an island, after the step has been accepted: has any block been pushed?
  bool push(const IslandEquations& island);

  /// Overlap that sweeps leave the contacts of an island, as they are in the trial [m]. What else has gone so deep is
  /// left to the pushes, as that is, from the first step of a motion on.
  [[nodiscard]] double left_by_sweeps_m(const IslandEquations& island) const;

 private:
  struct Push {
    std::vector<int> bodies;             ///< that move, by increasing number
    std::vector<Eigen::Vector3d> moved;  ///< each by (x, y, turn)

    [[nodiscard]] int number(int block) const;  ///< -1: does not move
  };

  void meet(const IslandEquations& island);
  [[nodiscard]] double lasting_m(const IslandEquations& island) const;
  [[nodiscard]] double enough_m(const IslandEquations& island, int pushes) const;
  [[nodiscard]] double deepest_m() const;
  void push_once(const IslandEquations& island);
  [[nodiscard]] Push find_push(const IslandEquations& island) const;
  [[nodiscard]] double affordable(const Push& push, double deepest_m) const;
  void carry_out(const IslandEquations& island, const Push& push, double share);
  void displace(std::size_t block, const Eigen::Vector3d& by);

  Meetings now_;
  double lasting_m_ = 0;
  std::vector<const ContactPoint*> passing_;  ///< corners of the island that no contact parts
  std::vector<Meeting> meetings_;             ///< of the island's contacts, then of these, as its blocks are now
};

}  // namespace blockweir::solid
