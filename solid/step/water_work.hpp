// SPDX-License-Identifier: GPL-3.0-or-later
// Work of the water on the scene's blocks, as summed by the solid's steps.
#pragma once

#include <vector>

#include "solid/block/panel.hpp"
#include "solid/block/water_motions.hpp"
#include "solid/step/added_mass_guard.hpp"

namespace blockweir::solid {

/// Force on the rigid unknowns (u0, v0, r0) of each block of the scene, summed over panels.
std::vector<Eigen::Vector3d> water_forces(const std::vector<Panel>& panels, const std::vector<Block>& blocks,
                                          const std::vector<Placement>& placements, std::size_t described,
                                          scene::NodalRule rule);

/// Energy from a force in a step is F d with Shi's scheme (force at the step's end), and (F0 + F1)/2 d with others. F
/// is that of the pressures, plus M_a (a' - a) with the guard, so that the guard only moves energy between blocks. For
/// a mesh whose bending the water responds to, the sums of forces and moments count.
class WaterWork {
 public:
  /// Positions and velocities of the blocks, and the motions that the water responds to.
  struct Blocks {
    const std::vector<BlockState>& states;
    const std::vector<Placement>& placements;
    const WaterMotions& motions;
  };
  /// Call at the start of a step with these pressure forces.
  void begin_step(std::vector<Eigen::Vector3d> forces, const AddedMassGuard& guard, const Blocks& blocks);
  /// Call after a step, by Shi's scheme or another.
  void end_step(const AddedMassGuard& guard, const Blocks& blocks, double dt, bool by_shi);

  [[nodiscard]] double sum_j_per_m() const { return sum_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(sum_, before_);
  }

 private:
  double sum_ = 0;
  std::vector<Eigen::Vector3d> before_;  ///< forces at the end of the last step
  std::vector<Eigen::Vector3d> forces_;  ///< of the present step
  std::vector<Eigen::Vector3d> displacement_;
  std::vector<Eigen::Vector3d> velocity_;  ///< of the guard's motions
};

}  // namespace blockweir::solid
