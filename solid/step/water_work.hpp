// SPDX-License-Identifier: GPL-3.0-or-later
// Work of the water on the scene's blocks, as the solid's steps count it.
#pragma once

#include <vector>

#include "solid/block/panel.hpp"
#include "solid/block/water_motions.hpp"
#include "solid/step/added_mass_guard.hpp"

namespace blockweir::solid {

/// On the six unknowns' rigid part (u0, v0, r0), of each of the scene's blocks, summed up over panels.
std::vector<Eigen::Vector3d> water_forces(const std::vector<Panel>& panels, const std::vector<Block>& blocks,
                                          const std::vector<Placement>& placements, std::size_t described,
                                          scene::NodalRule rule);

/// A step gains F d with Shi's scheme, whose force is that of the step's end, and (F0 + F1)/2 d with others; F is the
/// pressures' and, with the guard, M_a (a' - a), so that what the guard takes from the one it gives to the other. Of a
/// mesh whose bending the water answers it counts the sum of forces and moments.
class WaterWork {
 public:
  /// How blocks move, and the motions that the water answers.
  struct Blocks {
    const std::vector<BlockState>& states;
    const std::vector<Placement>& placements;
    const WaterMotions& motions;
  };
  /// A step begins under these forces of pressures.
  void begin_step(std::vector<Eigen::Vector3d> forces, const AddedMassGuard& guard, const Blocks& blocks);
  /// The step has been made, by Shi's scheme or another.
  void end_step(const AddedMassGuard& guard, const Blocks& blocks, double dt, bool by_shi);

  [[nodiscard]] double sum_j_per_m() const { return sum_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(sum_, before_);
  }

 private:
  double sum_ = 0;
  std::vector<Eigen::Vector3d> before_;  ///< forces of the last step's end
  std::vector<Eigen::Vector3d> forces_;  ///< of the step at hand
  std::vector<Eigen::Vector3d> displacement_;
  std::vector<Eigen::Vector3d> velocity_;  ///< of the guard's motions
};

}  // namespace blockweir::solid
