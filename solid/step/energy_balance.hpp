// SPDX-License-Identifier: GPL-3.0-or-later
// What loads and a moving base have given, and what springs hold: the part of a run's energy that no state tells.
#pragma once

#include <utility>
#include <vector>

#include "solid/block/motion.hpp"

namespace blockweir::solid {

/// A step gains F d with Shi's scheme, whose force is that of the step's end, and (F0 + F1)/2 d with others.
class EnergyBalance {
 public:
  /// Work of all given loads but weight and initial stress, and of supports and a base that move [J per metre].
  [[nodiscard]] double given_j_per_m() const { return given_; }
  /// In bolts and in contacts that are springs, since the run began [J per metre].
  [[nodiscard]] double stored_j_per_m() const { return stored_; }

  /// What acts on a block through a step that ends under `now`.
  [[nodiscard]] Vector6 through_step(std::size_t b, const Vector6& now, bool by_shi) const {
    return by_shi || before_.empty() ? now : Vector6((before_[b] + now) / 2);
  }
  void give(double work_j_per_m) { given_ += work_j_per_m; }
  void store(double rise_j_per_m) { stored_ += rise_j_per_m; }
  /// What of a block's group has been made of nothing and could not be taken back yet [J per metre].
  [[nodiscard]] double owed(std::size_t b) const { return owed_.empty() ? 0 : owed_[b]; }
  void owe(std::size_t b, double energy_j_per_m, std::size_t blocks) {
    if (owed_.empty() && energy_j_per_m == 0) return;
    owed_.resize(blocks);
    owed_[b] = energy_j_per_m;
  }
  /// How a base that moves has pushed a block through a step, which it ends with this force.
  [[nodiscard]] Point push_through_step(std::size_t b, const Point& now) const {
    return pushes_.empty() ? now : Point((pushes_[b] + now) / 2);
  }
  void end_step_pushed_by(std::vector<Point> pushes) { pushes_ = std::move(pushes); }
  /// The step has ended under these loads.
  void end_step(const std::vector<Vector6>& loads) { before_ = loads; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(given_, stored_, owed_, before_, pushes_);
  }

 private:
  double given_ = 0;
  double stored_ = 0;
  std::vector<double> owed_;     ///< none where nothing is
  std::vector<Vector6> before_;  ///< loads at the last step's end; none where steps do not look back
  std::vector<Point> pushes_;    ///< of a base that moves, then
};

}  // namespace blockweir::solid
