// SPDX-License-Identifier: GPL-3.0-or-later
// Separations of contacts and supports in the step, and the changes of their states.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "bridge/scene/at.hpp"
#include "solid/contact/joint_laws.hpp"
#include "solid/contact/trial.hpp"

namespace blockweir::solid {

/// Of a contact or support.
struct Progress {
  Eigen::Vector2d separation = Eigen::Vector2d::Zero();  ///< that is resisted, at the trial [m]
  double round_off = 0;                                  ///< uncertainty of the force [N per metre]
  double slip_force = 0;  ///< shear force of the evaluation before, whose sign is the direction of slip
  double last_violation = std::numeric_limits<double>::infinity();  ///< at the sweep before
  double stiffness = 0;  ///< of the blocks against the contact [N/m per metre]
  double overlap = 0;  ///< gap as the step began, where it aims [m]: of what overlaps, or pressed and was all but shut
  bool swept = false;  ///< its forces are a sweep's: of what sticks some slip may be left
  bool turning = false;  ///< slip was about to reverse and is tried as stick; not a state to end in

  /// The largest part of the separation that should be zero in this state; a support sticks.
  [[nodiscard]] double violation(ContactState state) const {
    return std::max(state == ContactState::open ? 0 : std::abs(separation.x()),
                    state == ContactState::stick ? std::abs(separation.y()) : 0);
  }
};

class StepProgress {
 public:
  /// The laws must outlive it.
  explicit StepProgress(const JointLaws& laws) : laws_(laws) {}

  void make_room(std::size_t contacts, std::size_t supports);
  [[nodiscard]] Progress& contact(int index) { return contacts_[at(index)]; }
  [[nodiscard]] const Progress& contact(int index) const { return contacts_[at(index)]; }
  [[nodiscard]] Progress& support(int index) { return supports_[at(index)]; }
  [[nodiscard]] const Progress& support(int index) const { return supports_[at(index)]; }
  [[nodiscard]] std::size_t contacts() const { return contacts_.size(); }

  /// Separation that the contact resists: the gap less what dilation has opened, and the slip.
  Progress& follow(const Trial& trial, int index, const ContactPoint& c, const EdgeFrame& edge);
  Progress& follow(const Trial& trial, int index, const Support& s);
  /// d(resisted gap)/d(slip) of a slipping contact that dilates; else 0.
  [[nodiscard]] double dilation_slope(const ContactPoint& c, const Progress& progress) const;

  void set_state(ContactPoint& c, ContactState state) {
    if (state != c.state) state_changes_.fetch_add(1, std::memory_order_relaxed);
    c.state = state;
  }
  /// Counted up by one for each contact whose state differs from the evaluation before.
  [[nodiscard]] long state_changes() const { return state_changes_; }

  template <class Archive>
  void serialize(Archive& archive) {
    long changes = state_changes_;
    archive(changes);
    state_changes_ = changes;
  }

 private:
  Progress& follow_dilation(const Trial& trial, const ContactPoint& c, const EdgeFrame& edge, Progress& progress) const;

  const JointLaws& laws_;
  std::vector<Progress> contacts_;
  std::vector<Progress> supports_;
  std::atomic<long> state_changes_ = 0;
};

}  // namespace blockweir::solid
