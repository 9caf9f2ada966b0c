// SPDX-License-Identifier: GPL-3.0-or-later
// Added-mass guard of the explicit schedule: (M + M_a) a = F + M_a a', F the water's force, held over the window, and
// a' the acceleration that F answers.
#pragma once

#include "solid/block/added_mass.hpp"
#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// Without it the water's inertia stands on the right-hand side alone, one window late: m a = F0 - m_a a' grows by
/// m_a/m a window. With it what is late is only m_a - M_a, what the estimate is off by; a steady acceleration, a = a',
/// is what it would be without any guard.
///
/// a' is the mean over the window before, by which the fluid has seen velocities change: (v_n - v_n-1)/window. It does
/// not depend on how many steps, of which scheme, the solid has made in it, nor on velocities that change at once in an
/// impact. The whole window solves with the same M_a and a'; so do all of its steps.
class AddedMassGuard {
 public:
  /// A window begins, its blocks in `states`. With no masses the guard is off.
  void begin_window(const AddedMasses& masses, const std::vector<BlockState>& states, double window_s);

  [[nodiscard]] bool acts() const { return !masses_.empty(); }
  /// M_a of a block of the scene.
  [[nodiscard]] const Eigen::Matrix3d& mass(std::size_t block) const { return masses_[block]; }
  /// M_a a', on (u0, v0, r0).
  [[nodiscard]] const Eigen::Vector3d& force(std::size_t block) const { return forces_[block]; }
  [[nodiscard]] std::size_t blocks() const { return masses_.size(); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(masses_, forces_, velocities_, window_s_);
  }

 private:
  AddedMasses masses_;
  std::vector<Eigen::Vector3d> forces_;
  std::vector<Eigen::Vector3d> velocities_;  ///< when the window began
  double window_s_ = 0;
};

}  // namespace blockweir::solid
