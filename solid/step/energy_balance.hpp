// SPDX-License-Identifier: GPL-3.0-or-later
// Work of loads and of a moving base, and energy in springs: the part of the energy that is not in the state.
#pragma once

#include <utility>
#include <vector>

#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// The energy from a force in a step is F d with Shi's scheme (force at the step's end), and (F0 + F1)/2 d with others.
class EnergyBalance {
 public:
  /// Work of all loads except weight and initial stress, and of moving supports and base [J per metre].
  [[nodiscard]] double given_j_per_m() const { return given_; }
  /// Energy in bolts and in springs of supports since the start of the run [J per metre]; contacts keep their own.
  [[nodiscard]] double stored_j_per_m() const { return stored_; }

  /// The force on a block for the step that ends under `now`.
  [[nodiscard]] Vector6 through_step(std::size_t b, const Vector6& now, bool by_shi) const {
    return by_shi || before_.empty() ? now : Vector6((before_[b] + now) / 2);
  }
  void give(double work_j_per_m) { given_ += work_j_per_m; }
  /// Of steps that are undone; the loads at their end stay, with which the next step begins.
  void undo_work_since(const EnergyBalance& before) {
    given_ = before.given_;
    stored_ = before.stored_;
    owed_ = before.owed_;
  }
  void store(double rise_j_per_m) { stored_ += rise_j_per_m; }
  /// Spurious energy of a block's group that could not be removed yet [J per metre].
  [[nodiscard]] double owed(std::size_t b) const { return owed_.empty() ? 0 : owed_[b]; }
  void owe(std::size_t b, double energy_j_per_m, std::size_t blocks) {
    if (owed_.empty() && energy_j_per_m == 0) return;
    owed_.resize(blocks);
    owed_[b] = energy_j_per_m;
  }
  /// The force of a moving base on a block for the step that ends with this force.
  [[nodiscard]] Point push_through_step(std::size_t b, const Point& now) const {
    return pushes_.empty() ? now : Point((pushes_[b] + now) / 2);
  }
  void end_step_pushed_by(std::vector<Point> pushes) { pushes_ = std::move(pushes); }
  /// Call at the end of a step under these loads.
  void end_step(const std::vector<Vector6>& loads) { before_ = loads; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(given_, stored_, owed_, before_, pushes_);
  }

 private:
  double given_ = 0;
  double stored_ = 0;
  std::vector<double> owed_;     ///< empty if there is none
  std::vector<Vector6> before_;  ///< loads at the end of the last step; empty for Shi's scheme
  std::vector<Point> pushes_;    ///< of a moving base at the end of the last step
};

}  // namespace blockweir::solid
