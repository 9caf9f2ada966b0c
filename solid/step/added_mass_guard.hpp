// SPDX-License-Identifier: GPL-3.0-or-later
// Added-mass guard of the explicit schedules: (M + M_a) a = F + M_a a', F the water's force, and a' the acceleration
// that F answers.
#pragma once

#include <vector>

#include "solid/block/added_mass.hpp"
#include "solid/block/motion.hpp"
#include "solid/block/water_course.hpp"

namespace blockweir::solid {

/// Without it the water's inertia stands on the right-hand side alone, one window late: m a = F0 - m_a a' grows by
/// m_a/m a window. With it what is late is only m_a - M_a, what the estimate is off by; a steady acceleration, a = a',
/// is what it would be without any guard.
///
/// a' is the change, since the exchange before, of the velocities that the fluid was told: (v_k - v_k-1)/(T_k - T_k-1).
/// It does not depend on how many steps, of which scheme, the solid makes, nor on velocities that change at once in an
/// impact. Where forces go on from exchange to exchange in time, so does a'. The whole window has the same M_a.
class AddedMassGuard {
 public:
  /// A window begins under forces that answer these velocities, of time_s. With no masses the guard is off.
  void begin_window(const AddedMasses& masses, const std::vector<Eigen::Vector3d>& velocities, double time_s);
  /// The factors that the window's forces have at the end of the step.
  void begin_step(const WaterCourse::Weights& weights);

  [[nodiscard]] bool acts() const { return !masses_.empty(); }
  [[nodiscard]] const AddedMasses& masses() const { return masses_; }
  /// M_a of a motion alone; the first are those of the scene's blocks.
  [[nodiscard]] const Eigen::Matrix3d& mass(std::size_t motion) const { return masses_.own[motion]; }
  /// M_a a', on the motion's three.
  [[nodiscard]] const Eigen::Vector3d& force(std::size_t motion) const { return forces_[motion]; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& forces() const { return forces_; }
  [[nodiscard]] std::size_t motions() const { return masses_.own.size(); }
  [[nodiscard]] std::size_t blocks() const { return masses_.blocks; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(masses_, velocities_, accelerations_, time_s_);
  }

 private:
  AddedMasses masses_;
  std::vector<Eigen::Vector3d> velocities_;                    ///< last told
  std::array<std::vector<Eigen::Vector3d>, 3> accelerations_;  ///< a', the last first
  std::vector<Eigen::Vector3d> forces_;
  double time_s_ = 0;
};

}  // namespace blockweir::solid
