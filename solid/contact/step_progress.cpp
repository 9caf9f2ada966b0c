// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/step_progress.hpp"

namespace blockweir::solid {

void StepProgress::make_room(std::size_t contacts, std::size_t supports) {
  contacts_.resize(contacts);
  supports_.resize(supports);
}

Progress& StepProgress::follow(const Trial& trial, int index, const ContactPoint& c, const EdgeFrame& edge) {
  Progress& progress = contacts_[at(index)];
  const JointProperties& law = laws_[c.law];
  if (law.dilates()) return follow_dilation(trial, c, edge, progress);
  const Separation found = separation_of(trial, c, edge);
  progress.separation = found.value;
  progress.separation.x() -= progress.overlap;
  progress.round_off = separation_round_off * c.penalty * found.moved;
  return progress;
}

/// What the joint has opened before the step is taken off the gap first: in increments both are free of cancellation.
Progress& StepProgress::follow_dilation(const Trial& trial, const ContactPoint& c, const EdgeFrame& edge,
                                        Progress& progress) const {
  const JointProperties& law = laws_[c.law];
  const double opened_m = law.dilation_m(c.slip_m);
  ContactPoint resisted = c;
  resisted.separation -= opened_m * edge.n;
  const Separation found = separation_of(trial, resisted, edge);
  progress.separation = found.value;
  progress.separation.x() -= law.opens_by(c.slip_m, found.value.y()) + progress.overlap;
  const bool edge_turns = trial.increment[at(c.edge_part)][2] != 0;
  progress.round_off = separation_round_off * c.penalty * (found.moved + (edge_turns ? opened_m : 0));
  return progress;
}

Progress& StepProgress::follow(const Trial& trial, int index, const Support& s) {
  Progress& progress = supports_[at(index)];
  const Separation found = separation_of(trial, s);
  progress.separation = found.value;
  progress.round_off = separation_round_off * s.penalty * found.moved;
  return progress;
}

double StepProgress::dilation_slope(const ContactPoint& c, const Progress& progress) const {
  if (c.state != ContactState::slip) return 0;
  return laws_[c.law].dilation_slope(c.slip_m + progress.separation.y(), -progress.slip_force);
}

}  // namespace blockweir::solid
