// SPDX-License-Identifier: GPL-3.0-or-later
// The time step as an algorithm: search, assemble, solve, open-close, accept or reduce, update.
#pragma once

#include "solid/step/equilibrium.hpp"
#include "solid/step/step_islands.hpp"

namespace blockweir::solid {

class TimeStep : StepPart {
 public:
  TimeStep(StepWorkspace& step, WaterInertia& water) : StepPart(step), water_(water), islands_(step, water) {}

  /// Tries one step by one method. Unless the step is made, the state is unchanged.
  Outcome attempt(const Stretch& stretch, const StepMode& mode);

  /// Whether a contact closed, opened, or started or stopped slipping in the last step.
  [[nodiscard]] bool contacts_change();
  [[nodiscard]] bool any_swept() const;
  [[nodiscard]] StepIslands& islands() { return islands_; }
  /// Finds the contacts that the next attempt begins with.
  void find_contacts_ahead();
  /// Drops everything kept from earlier steps.
  void begin_anew();

 private:
  [[nodiscard]] double timed() const;
  Outcome attempt_again(const Stretch& stretch, const StepMode& mode);
  void begin_with_forces_tried();
  [[nodiscard]] bool has_seen(bool made, double moved_m, const StepMode& mode);
  [[nodiscard]] bool any_missed();
  [[nodiscard]] bool slid_over_its_end(const ContactPoint& c) const;
  [[nodiscard]] bool any_found(Found what) const;
  bool find_contacts();
  void search();
  void begin(const Stretch& stretch, const StepMode& mode);
  void begin_contacts(const StepMode& mode);
  void push_boundary(const scene::TimeSpan& span);
  bool solve(const StepMode& mode);

  WaterInertia& water_;
  StepIslands islands_;
  std::vector<ContactPoint> tried_;  ///< contacts as solved by sweeps in an attempt that lacked others
};

}  // namespace blockweir::solid
