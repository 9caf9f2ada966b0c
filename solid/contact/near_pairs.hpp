// SPDX-License-Identifier: GPL-3.0-or-later
// Which blocks are so near each other that they may touch, found anew once some have moved far enough.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "solid/contact/current_outlines.hpp"
#include "solid/contact/joint_openings.hpp"
#include "solid/contact/neighbours.hpp"

namespace blockweir::solid {

class NearPairs {
 public:
  /// Two blocks may each move in a step, one towards the other.
  static constexpr double reach_per_move = 2.5;
  /// The reach begins with `reach_m` and grows with what blocks move, up to `farthest_reach_m`.
  NearPairs(double reach_m, double farthest_reach_m, std::size_t blocks);

  /// Moves the outlines to `placements`, and the boxes around them with them.
  void refresh(const std::vector<Placement>& placements, CurrentOutlines& outlines, JointOpenings& openings);

  [[nodiscard]] const std::vector<std::pair<int, int>>& all() const { return pairs_; }
  /// Around a block, wider by half the reach and by what its joints have opened.
  [[nodiscard]] const Box& box(int block) const { return boxes_[at(block)]; }
  /// Gaps up to it are contacts in waiting [m].
  [[nodiscard]] double reach_m() const { return reach_; }
  /// Does the reach allow for vertices that move so far? If not, it will as pairs are found next.
  [[nodiscard]] bool covers(double moved_m);
  [[nodiscard]] long searches() const { return searches_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(corners_at_pairs_, pairs_, searches_, reach_);
  }

 private:
  /// Pairs stay valid while no block has moved half of it [m].
  [[nodiscard]] double margin() const { return 2 * reach_; }

  double reach_;                                      ///< m
  double farthest_reach_;                             ///< m
  std::vector<Box> boxes_;                            ///< current
  std::vector<std::vector<Point>> corners_at_pairs_;  ///< as pairs were found
  std::vector<std::pair<int, int>> pairs_;
  long searches_ = 0;
};

}  // namespace blockweir::solid
