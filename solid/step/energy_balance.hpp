// SPDX-License-Identifier: GPL-3.0-or-later
// What loads and a moving base have given, and what springs hold: the part of a run's energy that no state tells.
#pragma once

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
  /// How a base that moves has done so in a step.
  struct Lead {
    Point moved = Point::Zero();  ///< m
    Point began = Point::Zero();  ///< at this velocity [m/s]
    Point ended = Point::Zero();  ///< m/s
    [[nodiscard]] Point mean() const { return (began + ended) / 2; }
  };
  /// The base moves so far in the step of dt, ends it at a velocity, and pushes the structure with this force. Work is
  /// that of its impulse at the mean velocity: by that momentum, and so motion, changes.
  void lead(const Point& push, const Point& moved, const Point& velocity, double dt, bool by_shi) {
    lead_ = {moved, lead_.ended, velocity};
    give(dt * (by_shi ? push : Point((push_ + push) / 2)).dot(lead_.mean()));
    push_ = push;
  }
  [[nodiscard]] const Lead& lead() const { return lead_; }
  /// The step has ended under these loads.
  void end_step(const std::vector<Vector6>& loads) { before_ = loads; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(given_, stored_, owed_, before_, push_, lead_.moved, lead_.began, lead_.ended);
  }

 private:
  double given_ = 0;
  double stored_ = 0;
  std::vector<double> owed_;     ///< none where nothing is
  std::vector<Vector6> before_;  ///< loads at the last step's end; none where steps do not look back
  Point push_ = Point::Zero();   ///< of the base, then
  Lead lead_;                    ///< of it, in the last step
};

}  // namespace blockweir::solid
