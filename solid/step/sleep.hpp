// SPDX-License-Identifier: GPL-3.0-or-later
// Finds blocks so close to rest, under constant loads, that a step may skip them.
#pragma once

#include <vector>

#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// A block rests if a step moves no vertex by more than 1e-12 of the model's size and 1e-7 of a free fall in the step.
/// After three such steps it may sleep, until its load differs from that at which it fell asleep. The second limit
/// keeps a just released block awake, which at very short steps hardly moves either. Velocities are no criterion: with
/// long steps those of Shi's scheme change sign for hundreds of steps while nothing moves.
class Sleep {
 public:
  Sleep(std::size_t blocks, double size_m) : rests_(blocks, 0), load_(blocks, Vector6::Zero()), size_(size_m) {}

  /// Call after an accepted step of length dt; `increments` are those of the blocks (centroid [m], rotation, strains),
  /// `external` their loads.
  void look(const std::vector<Block>& blocks, const std::vector<Vector6>& increments,
            const std::vector<Vector6>& external, double dt);

  /// Marks block b as not at rest.
  void wake(std::size_t b) { rests_[b] = 0; }

  /// Whether block b has rested long enough and its load is the same to within `tolerance_n`.
  [[nodiscard]] bool rests(std::size_t b, const std::vector<Block>& blocks, const std::vector<Vector6>& external,
                           double tolerance_n) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(rests_, load_);
  }

 private:
  static constexpr int long_enough = 3;
  std::vector<int> rests_;     ///< consecutive steps at rest
  std::vector<Vector6> load_;  ///< at which the block fell asleep
  double size_;
};

}  // namespace blockweir::solid
