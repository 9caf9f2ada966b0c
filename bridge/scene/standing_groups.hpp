// SPDX-License-Identifier: GPL-3.0-or-later
// Structures of a scene: groups of blocks that can move and touch. What retains water stands on the ground; a deck on
// supports of its own, or a stone in the air, does not.
#pragma once

#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

struct StandingGroup {
  double foot_m;
  double top_m;
  int highest;     ///< its block that reaches the top
  bool on_ground;  ///< touches a fixed block; true for all where none does
};

struct StandingGroups {
  std::vector<StandingGroup> all;
  std::vector<int> of_block;  ///< -1: fixed

  [[nodiscard]] bool on_ground(std::size_t block) const;
};

/// The highest point of what can move and stands on the ground; minus infinity if nothing can move.
double retaining_top_m(const StandingGroups& groups);

/// Of each block: is it ground, or does it stand on the ground?
std::vector<bool> retaining_blocks(const std::vector<Block>& blocks);

/// Blocks count as touching where the boxes around them do.
StandingGroups standing_groups(const std::vector<Block>& blocks);

}  // namespace blockweir::scene
