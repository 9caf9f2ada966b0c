// SPDX-License-Identifier: GPL-3.0-or-later
// Which blocks rest so still, under loads so steady, that a step would leave them as they are.
#pragma once

#include <vector>

#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// A block rests while a step moves no vertex by more than 1e-12 of the model, and by no more than 1e-7 of what it
/// would fall; after three such steps it may sleep, until its load differs from that under which it fell asleep. The
/// second bound keeps a block awake that has just been released: at very short steps it hardly moves either. Velocities
/// do not tell: with long steps those of Shi's scheme change sign for hundreds of steps while nothing moves.
class Sleep {
 public:
  Sleep(std::size_t blocks, double size_m) : rests_(blocks, 0), load_(blocks, Vector6::Zero()), size_(size_m) {}

  /// After an accepted step of length dt that moved the blocks by `increments` (of the centroid [m], rotation, strains)
  /// under `external`.
  void look(const std::vector<Block>& blocks, const std::vector<Vector6>& increments,
            const std::vector<Vector6>& external, double dt);

  /// Block b does not rest, whatever it seems to have done so far.
  void wake(std::size_t b) { rests_[b] = 0; }

  /// Has block b rested long enough, and is its load the same to within `tolerance_n`?
  [[nodiscard]] bool rests(std::size_t b, const std::vector<Block>& blocks, const std::vector<Vector6>& external,
                           double tolerance_n) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(rests_, load_);
  }

 private:
  static constexpr int long_enough = 3;
  std::vector<int> rests_;     ///< steps at rest on end
  std::vector<Vector6> load_;  ///< under which the block fell asleep
  double size_;
};

}  // namespace blockweir::solid
