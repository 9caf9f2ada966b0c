// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/time_step.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/results/stopwatch.hpp"
#include "bridge/results/wide_vectors.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/step/island_sleep.hpp"
#include "solid/step/push_apart.hpp"
#include "solid/step/step_end.hpp"
#include "solid/step/step_errors.hpp"

namespace blockweir::solid {
namespace {

// Of a fall through the step: closed in one, an overlap gets a velocity of that share of the fall's.
constexpr double lasting_overlap = 5e-5;

}  // namespace

Outcome TimeStep::attempt(const Stretch& stretch, const StepMode& mode) {
  tried_.clear();
  return attempt_again(stretch, mode);
}

Outcome TimeStep::attempt_again(const Stretch& stretch, const StepMode& mode) {
  free_upper_halves();
  step_.go_on();
  if (mode.in_motion()) step_.must_move = step_.held = false;
  const Stopwatch::Sample sample(timed());
  if (model_.is(scene::AnalysisKind::quasi_static)) state_.stop();
  const long touching = !mode.smooth_only ? 0 : state_.touched_before.value_or(state_.touching_contacts());
  const bool searched = find_contacts();
  if (mode.smooth_only && state_.touching_contacts() != touching) {  // the search has dropped one
    return Outcome::contacts_change;
  }
  const long state_changes_before = formulation_->progress().state_changes();
  if (searched || islands_.empty() || state_.guard.acts()) islands_.prepare();
  begin(stretch, mode);
  begin_with_forces_tried();
  const bool solved = solve(mode);
  const double moved = trial_.moved_m = trial_.largest_increment();
  StepEnd end(step_, islands_, water_);
  Outcome outcome = Outcome::made;
  if (!solved) {
    outcome = Outcome::not_found;
  } else if (trial_.goes_too_far()) {
    outcome = Outcome::too_far;
  } else if (mode.smooth_only && (contacts_change() || !end.affords_motion(stretch.dt))) {
    outcome = Outcome::contacts_change;
  }
  const bool seen = has_seen(outcome == Outcome::made, moved, mode);
  if (outcome != Outcome::made || !seen) {
    if (!seen && (any_swept() || any_found(Found::by_newton_after_sweeps))) tried_ = state_.contacts;
    for (IslandEquations& s : islands_) formulation_->undo(s.island_contacts());
    state_.contacts_stand = seen;
    return seen ? outcome : attempt_again(stretch, mode);
  }
  if (mode.in_motion()) {
    const bool stands = step_.held || moved == 0;
    counts_.unheld_steps = step_.must_move ? counts_.unheld_steps + 1 : stands ? 0 : counts_.unheld_steps;
  }
  const bool otherwise = end.accept(stretch, mode);
  state_.contacts_stand = moved == 0 && formulation_->progress().state_changes() == state_changes_before && !otherwise;
  require_finite(step_, stretch.end_s);
  return Outcome::made;
}

/// Did the search know all contacts that the step has met?
bool TimeStep::has_seen(bool made, double moved_m, const StepMode& mode) {
  if (any_found(Found::corners)) return false;
  if (!made) return true;
  if (!state_.search.covers(moved_m)) return false;
  if (moved_m == 0) return true;
  double left_m = 0;
  for (const IslandEquations& s : islands_) {
    if (s.found == Found::by_sweeps) left_m = std::max(left_m, PushApart(step_).left_by_sweeps_m(s));
  }
  if (state_.search.entered(trial_.placement, state_.contacts, left_m)) return false;
  if (mode.in_motion() && state_.search.turned_on(trial_.placement, left_m)) return false;
  if (mode.in_motion() && any_missed()) return false;
  state_.search.forget_step();
  return true;
}

/// Did one end of the contact's edge press on a side of its vertex as the step began? That end keeps the vertex's block
/// off, whatever becomes of the contact.
bool TimeStep::slid_over_its_end(const ContactPoint& c) const {
  const std::size_t corners = model_.parts.contact_outlines[at(c.vertex_block)].size();
  const std::size_t sides = model_.parts.contact_outlines[at(c.edge_block)].size();
  const auto [first, last] = std::equal_range(state_.contacts.begin(), state_.contacts.end(), c, of_lower_pair);
  for (auto other_at = first; other_at != last; ++other_at) {
    const ContactPoint& other = *other_at;
    if (other.vertex_block != c.edge_block) continue;
    const bool at_end = other.vertex == c.edge || at(other.vertex) == next(at(c.edge), sides);
    const bool on_side = other.edge == c.vertex || next(at(other.edge), corners) == at(c.vertex);
    const bool pressed = formulation_->before().contact(static_cast<int>(other_at - state_.contacts.begin())).state !=
                         ContactState::open;
    if (at_end && on_side && pressed) return true;
  }
  return false;
}

/// Of the contacts that closed in the step: did one press beyond the end of its edge, though its vertex had left that
/// before it came to it? The rear corner of a block that slides over an edge and tips does: its face turns about the
/// edge, and the way that it goes on is along that face, not along the line of what it has left.
bool TimeStep::any_missed() {
  bool any = false;
  for (std::size_t k = 0; k < state_.contacts.size(); ++k) {
    const ContactPoint& c = state_.contacts[k];
    const bool was_open = formulation_->before().contact(static_cast<int>(k)).state == ContactState::open;
    if (c.state == ContactState::open || !was_open || !slid_over_its_end(c)) continue;
    const Interaction ends = interaction_of(c, edge_frame(trial_.at_start(), c), 0);
    Point expected = Point::Zero();  // its way off the edge, and along it
    for (const bool second : {false, true}) {
      const auto b = at(ends.block(second));
      const Vector6 rate = trial_.rate(b, state_.placements[b], state_.blocks[b].velocity);
      expected += (second ? -trial_.dt : trial_.dt) * (ends.shape(state_.placements[b], second) * rate);
    }
    const double slip = separation_of(trial_.now(), c, edge_frame(trial_.now(), c)).value.y();
    any = state_.search.missed(c, {-expected.x(), expected.y()}, slip, trial_.fall_m()) || any;
  }
  return any;
}

/// Loads of the step, and the initial state of its blocks and supports.
void TimeStep::begin(const Stretch& stretch, const StepMode& mode) {
  trial_.end_s = stretch.end_s;
  trial_.find_sliding_blocks();
  trial_.set_matrices(stretch.dt, mode.scheme);
  // The base moves from time 0 on: before, weight and first loads settle on a base at rest.
  const bool base_moves = !mode.settles || model_.is(scene::AnalysisKind::at_rest);
  const bool has_time = model_.is(scene::AnalysisKind::dynamic) && !mode.settles;
  const scene::TimeSpan span(has_time ? stretch.end_s - stretch.dt : stretch.end_s, stretch.end_s);
  model_.loads.evaluate(span, stretch.water, state_.placements, trial_.external, base_moves);
  if (!model_.boundary.empty() && mode.scheme.damps) push_boundary(span);
  if (state_.guard.acts()) water_.begin_step(stretch.dt);
  require_finite_loads(step_, stretch.end_s);
  trial_.begin();
  for (Support& support : state_.supports) {
    const auto b = at(support.block);
    const auto wanted = [&](double time_s) -> Point {
      return support.target(time_s) + model_.base.displacement(time_s);
    };
    support.separation = state_.placements[b].displacement(support.material) - wanted(span.to_s);
    support.led = wanted(span.to_s) - wanted(span.from_s);
  }
  begin_contacts(mode);
}

/// Forces of the ground beyond: those that held it at rest, and incoming waves.
void TimeStep::push_boundary(const scene::TimeSpan& span) {
  for (std::size_t b = 0; b < state_.held_by_ground.size(); ++b) trial_.external[b] += state_.held_by_ground[b];
  model_.boundary.add_free_field(model_.base, span, !trial_.scheme.second_order(), trial_.external);
}

void TimeStep::begin_contacts(const StepMode& mode) {
  const double share_of_fall = std::min(1e-8 * model_.size_m, lasting_overlap * trial_.fall_m());
  formulation_->settings().lasting_overlap_m =
      mode.in_motion() ? std::max(model_.scene.contact.penetration_tolerance_m, share_of_fall) : 0;
  for (IslandEquations& s : islands_) {  // those asleep, too: a softened step lowers the penalties of all alike
    const IslandContacts contacts = s.island_contacts();
    formulation_->begin(trial_.at_start(), trial_.matrix, trial_.frozen, contacts);
    if (s.unknowns->total > large_island) formulation_->keep_forces(trial_.at_start(), contacts);
  }
}

/// Where the step is tried again with contacts that it lacked, sweeps go on from the forces that they had found.
void TimeStep::begin_with_forces_tried() {
  trial_.first_force.clear();
  if (tried_.empty()) return;
  auto was = tried_.begin();
  for (const ContactPoint& c : state_.contacts) {
    while (was != tried_.end() && precedes(*was, c)) ++was;
    const bool acts = was != tried_.end() && was->same_key(c) && was->state != ContactState::open;
    trial_.first_force.push_back(acts ? was->force : Eigen::Vector2d(0, 0));
  }
}

/// Equilibrium of all islands, each by itself.
bool TimeStep::solve(const StepMode& mode) {
  const bool sweeps = may_sweep(step_, mode);
  const bool newton = !sweeps || (trial_.first_force.empty() && !state_.whole_law.skips());
  bool solved = true;
  bool all_by_newton = true;
  const bool falls = sweeps && trial_.falls();  // then a result close to that of sweeps does not show that Newton's
                                                // method would converge
  IslandSleep sleep(step_);
  for (IslandEquations& island : islands_) {
    island.found = Found::nothing;
    if (sleep.may_begin(island, mode)) {
      sleep.begin(island);
      continue;
    }
    const Stopwatch watch(profile_.equilibria);
    ++counts_.solved_islands;
    if (solved) island.found = find_equilibrium(step_, island, mode, newton);
    solved = solved && island.found != Found::nothing && island.found != Found::corners;
    all_by_newton = all_by_newton &&
                    (island.found == Found::by_newton || (island.found == Found::by_newton_after_sweeps && !falls));
  }
  if (sweeps && (newton || (all_by_newton && !falls))) {
    all_by_newton ? state_.whole_law.succeeded() : state_.whole_law.failed();
  }
  return solved;
}

bool TimeStep::any_found(Found what) const {
  return std::any_of(islands_.begin(), islands_.end(), [&](const auto& s) { return s.found == what; });
}

bool TimeStep::any_swept() const {
  return any_found(Found::by_sweeps) || any_found(Found::corners);
}

void TimeStep::begin_anew() {
  trial_.dt = -1;
  islands_.clear();
}

bool TimeStep::contacts_change() {
  return std::any_of(islands_.begin(), islands_.end(),
                     [this](IslandEquations& s) { return formulation_->before().differs(s.island_contacts()); });
}

/// False where contacts are those of the step before.
bool TimeStep::find_contacts() {
  if (std::exchange(state_.touched_before, {})) return true;
  if (state_.contacts_stand && model_.scene.analysis.skip_searches) {
    ++counts_.skipped_searches;
    return false;
  }
  search();
  return true;
}

void TimeStep::find_contacts_ahead() {
  if (state_.touched_before || (state_.contacts_stand && model_.scene.analysis.skip_searches)) return;
  state_.touched_before = state_.touching_contacts();
  search();
}

void TimeStep::search() {
  const Stopwatch watch(profile_.search);
  ++counts_.searches;
  state_.search.update(state_.placements, state_.contacts);
}

/// In islands of few blocks, phases of a step take no longer than reading the clock: after the first steps, one in 16
/// is timed and counts for all.
double TimeStep::timed() const {
  constexpr std::size_t few_blocks = 16;  // an island
  constexpr long steps = 16;
  if (model_.blocks.size() > few_blocks * std::max<std::size_t>(1, islands_.size()) || counts_.steps < steps) return 1;
  return counts_.steps % steps == 0 ? static_cast<double>(steps) : 0;
}

}  // namespace blockweir::solid
