// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/swept_equilibrium.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/contact/bonds.hpp"
#include "solid/solve/moving_forces.hpp"
#include "solid/solve/standing_forces.hpp"
#include "solid/step/equilibrium.hpp"
#include "solid/step/moves_little.hpp"
#include "solid/step/push_apart.hpp"
#include "solid/step/restore_unless.hpp"
#include "solid/step/temporarily.hpp"

namespace blockweir::solid {
namespace {

constexpr int rounds = 2;  // blocks turn: forces act along other directions where that has taken them
constexpr std::array<double, 3> share_of_round = {0.3, 0.7, 0.1};  // of the sweeps; corners show in the first already
constexpr double most_visits = 3e4;                                // to contacts, in two rounds, while blocks fall
constexpr double most_slow_visits = 3e6;                           // slowest: what sweeps leave would add up to a creep
constexpr double least_sweeps = 100;                               // where an island is large
constexpr double most_sweeps = 1000;
constexpr double most_at_first = 400;  // of the first step that is swept: what follows begins with its forces

}  // namespace

Found SweptEquilibrium::find(IslandEquations& s, const StepMode& mode) {
  state_.has_fallen = state_.has_fallen || trial_.falls();
  if (s.is_free() && fly(s)) return Found::by_newton_after_sweeps;
  ++counts_.swept_islands;
  moves_m_ = trial_.fastest_m_per_s() * trial_.dt;
  begin(s);
  const bool few = s.unknowns->total <= few_unknowns;
  const bool begins = !state_.whole_law.after_failure();
  const double closely = begins || few ? 1e-4 : 1;
  const double enough_m = closely * std::min(2e-8 * model_.size_m, enough_share * trial_.fall_m());
  constexpr int most_rounds = 20;  // bonds break a few at a time
  double left_m = 0;
  bool broken = false;
  SweepRows rows(step_);
  for (int round = 1;; ++round) {
    if (!linearize(s, rows, round == 1)) return Found::nothing;
    const int most = static_cast<int>(most_of(s) * share_of_round[std::min(round, 3) - 1]);
    left_m = sweep(s, most, enough_m);
    s.correction = s.sweeps.displacement();
    if (!s.correction.allFinite()) return Found::nothing;
    s.move(1);
    take_forces(s);
    if (turns_too_far(s)) return Found::by_sweeps;  // the step is, too
    if (round == 1) {
      const double left = PushApart(step_).left_by_sweeps_m(s);
      if (state_.search.entered(trial_.placement, state_.contacts, left, s.island.blocks)) return Found::corners;
    }
    broken = break_bonds(model_.laws, formulation_->settings().force_tolerance_n, model_.blocks, s.island.contacts,
                         state_.contacts);
    if (round >= rounds && (!broken || round >= most_rounds)) break;
  }
  // From states and forces that are next to right Newton's method is exact in a solution or two. It is worth that to
  // some blocks; to many, from sweeps that came as close as in the first such step.
  constexpr int some_unknowns = 600;
  const bool worth = s.unknowns->total <= some_unknowns || (!trial_.falls() && begins);
  const bool near = left_m <= enough_m && formulation_->holds_exactly() && worth;
  if (near && (few || !state_.finish.skips())) {
    const bool exact = restore_unless(step_, s, mode, [&] { return finish(s, mode); });
    if (!few) exact ? state_.finish.succeeded() : state_.finish.failed();
    if (exact) return Found::by_newton_after_sweeps;
  }
  // Off by more than a fall through the step, a structure that stands would be thrown; statics would take it for slip.
  constexpr double of_statics = 1e-6;  // of the size
  const double most_m = mode.in_motion() ? trial_.fall_m() : std::min(trial_.fall_m(), of_statics * model_.size_m);
  if (left_m > most_m && !mode.roughly && !trial_.falls()) return Found::nothing;
  s.left_m = left_m;
  if (near || broken) take_forces(s);  // else they act
  s.balance_alone();
  s.find_residual([&](std::size_t k) { s.add_forces(k); });
  return Found::by_sweeps;
}

/// Sweeps of a step: the more, the less the structure moves in it, and in the first step that is swept.
double SweptEquilibrium::most_of(const IslandEquations& s) const {
  const bool first = !state_.whole_law.after_failure() && trial_.first_force.empty();
  const double visits = moves_m_ > 0
                            ? std::clamp(most_visits * trial_.fall_m() / moves_m_, most_visits, most_slow_visits)
                            : most_slow_visits;
  const double most = std::clamp(visits / static_cast<double>(s.sweeps.rows().size()), least_sweeps, most_sweeps);
  return first ? std::max(most, most_at_first) : most;
}

/// What nothing touches moves as its loads have it: one solution is exact.
bool SweptEquilibrium::fly(IslandEquations& s) {
  s.balance_alone();
  s.find_residual({});
  if (!SweepRows(step_).begin(s)) return false;
  s.move(1);
  s.balance_alone();
  return s.find_residual({}) <= formulation_->settings().force_tolerance_n;
}

/// Begins with the forces found, to the last digit, so that their states stand, and with softer penalties: these leave
/// sticking contacts a range of slips that Newton's method does not pass by.
bool SweptEquilibrium::finish(IslandEquations& s, const StepMode& mode) {
  const double softer = s.unknowns->total <= few_unknowns ? 1 : 1e-3;
  for (const int k : s.island.contacts) state_.contacts[at(k)].penalty *= softer;
  for (const int k : s.island.supports) state_.supports[at(k)].penalty *= softer;
  formulation_->keep_forces(trial_.now(), s.island_contacts());
  return find_by_newton(step_, s, mode);
}

/// Forces act along other lines than they were found for: at a new round they would let go of what they have thrown.
bool SweptEquilibrium::turns_too_far(const IslandEquations& s) const {
  return std::any_of(s.island.blocks.begin(), s.island.blocks.end(), [&](int block) {
    return !model_.blocks[at(block)].is_part() && std::abs(trial_.increment[at(block)][2]) > most_turn_in_step;
  });
}

/// Displacement in the last sweep, or in the one closest to convergence.
double SweptEquilibrium::sweep(IslandEquations& s, int most, double enough_m) {
  const Stopwatch watch(profile_.sweeps);
  step_.go_on();
  counts_.sweeps += s.sweeps.settle(most, enough_m);
  step_.go_on();
  return s.sweeps.take_nearest();
}

void SweptEquilibrium::begin(IslandEquations& s) {
  const IslandContacts contacts = s.island_contacts();
  formulation_->undo(contacts);
  start_again(s);
  const Temporarily swept(formulation_->settings().swept, true);
  formulation_->begin(trial_.at_start(), trial_.matrix, trial_.frozen, contacts);
}

/// The trial goes on as blocks move.
void SweptEquilibrium::start_again(const IslandEquations& s) {
  for (const int block : s.island.blocks) {
    const auto b = at(block);
    if (!model_.blocks[b].is_part()) {
      trial_.predict(b);
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      trial_.node_increment[at(model_.blocks[b].nodes[at(i)])] =
          trial_.dt * state_.blocks[b].velocity.segment<2>(2 * i);
    }
  }
  for (const int block : s.island.blocks) {
    if (model_.blocks[at(block)].is_part()) trial_.follow_corners(at(block));
  }
}

/// Gaps and slips about the trial, and what forces do to them.
bool SweptEquilibrium::linearize(IslandEquations& s, SweepRows& rows, bool first_round) {
  const Stopwatch watch(profile_.assembly);
  s.balance_alone();
  s.find_residual({});
  if (!rows.begin(s)) return false;
  add_contacts(s, rows, first_round);
  const Trial now = trial_.now();
  for (const int k : s.island.supports) {
    const Support& support = state_.supports[at(k)];
    rows.add(s, formulation_->ruled_support(now, k, support), interaction_of(support), support.force);
  }
  for (const int k : s.bolts) {
    const Interaction action = interaction_of(now, state_.bolts[at(k)], model_.base.displacement(trial_.end_s));
    rows.add(s, ruled_bolt(now, state_.bolts[at(k)], model_.base.displacement(trial_.end_s)), action, action.force);
  }
  constexpr double slow = 0.2;  // of a fall through the step
  if (first_round && moves_m_ <= slow * trial_.fall_m() && is_dry(s)) stand_or_go(s);
  s.sweeps.apply_forces();
  return true;
}

/// Where blocks move by themselves, rows are set side by side.
void SweptEquilibrium::add_contacts(IslandEquations& s, SweepRows& rows, bool first_round) {
  const Trial now = trial_.now();
  const bool cold = first_round && pumps(s);
  const auto add = [&](std::size_t i) {
    const ContactPoint& c = state_.contacts[at(s.island.contacts[i])];
    rows.add(s, c.vertex_part, c.edge_part);
  };
  const auto set = [&](std::size_t i) {
    const int k = s.island.contacts[i];
    const ContactPoint& c = state_.contacts[at(k)];
    const EdgeFrame edge = edge_frame(now, c);
    const Ruled ruled = formulation_->ruled_contact(now, k, c, edge);
    rows.set(s, s.sweeps.rows()[i], ruled, interaction_of(c, edge, ruled.apart.y()),
             cold                                         ? Point(0, 0)
             : first_round && !trial_.first_force.empty() ? trial_.first_force[at(k)]
             : c.state == ContactState::open              ? Point(0, 0)
                                                          : c.force);
  };
  const std::size_t count = s.island.contacts.size();
  if (!s.moves_as_one()) {
    for (std::size_t i = 0; i < count; ++i) add(i);
    return for_each(count, set);
  }
  for (std::size_t i = 0; i < count; ++i) {
    add(i);
    set(i);
  }
}

/// Has energy that the steps before made, and that no motion could pay, come to a share of a fall's through the step?
/// Then forces have grown in jams, from step to step, that too few sweeps undo: they begin with none. Not where these
/// would be too few to find them anew.
bool SweptEquilibrium::pumps(const IslandEquations& s) const {
  constexpr double share = 1e-2;
  constexpr double enough_sweeps = 200;
  if (most_visits < enough_sweeps * static_cast<double>(s.island.contacts.size())) return false;
  double owed = 0;
  double fall = 0;
  for (const int block : s.island.blocks) {
    owed += state_.energy.owed(at(block));
    fall += model_.blocks[at(block)].mass_per_m() * model_.scene.analysis.gravity_m_per_s2 * trial_.fall_m();
  }
  return fall > 0 && owed > share * fall;
}

/// Blocks in dry contacts alone.
bool SweptEquilibrium::is_dry(const IslandEquations& s) const {
  if (s.moves_as_one() || !s.island.supports.empty() || !s.bolts.empty()) return false;
  const auto& rows = s.sweeps.rows();
  return std::all_of(rows.begin(), rows.end(), [](const ForceRow& r) { return r.rule.is_dry(); });
}

/// What will move soon, if it does not now, has no creep that is to be kept small.
void SweptEquilibrium::stand_or_go(IslandEquations& s) {
  const bool rests = moves_little(step_, s);
  std::vector<Matrix6> matrix;
  for (const int block : s.island.blocks) matrix.push_back(trial_.matrix[at(block)]);
  if (rests && held_ != Held::no && stand(s, matrix)) return;
  constexpr int many_unknowns = 10'000;    // beyond, the first step takes too long
  const bool begins = !state_.has_fallen;  // what lies after a fall need not move exactly
  const bool strains = s.unknowns->total != 3 * s.unknowns->blocks();
  if (begins && s.unknowns->total > few_unknowns && s.unknowns->total <= many_unknowns) {
    go(s, matrix);
  } else if (rests && !strains) {
    moves_m_ = trial_.fall_m();
  }
}

/// Begins with forces by which nothing moves, if there are such. Sweeps would come to them only in the limit, and let
/// the structure creep until then.
bool SweptEquilibrium::stand(IslandEquations& s, const std::vector<Matrix6>& matrix) {
  StandingForces forces(s.sweeps, *s.unknowns, matrix);
  if (!forces.found(s.residual, enough_share * trial_.fall_m())) return false;
  take(s, forces);
  return true;
}

/// Begins with forces that let many blocks move slowly. What sweeps alone would leave is more than such a motion. Where
/// such forces are hard to find it is not that slow.
void SweptEquilibrium::go(IslandEquations& s, const std::vector<Matrix6>& matrix) {
  constexpr double near = 10;  // of what is enough
  if (state_.moving_forces.skips()) return;
  MovingForces forces(s.sweeps, *s.unknowns, matrix);
  const double enough_m = enough_share * trial_.fall_m();
  const double left_m = forces.find(s.residual, enough_m);
  const bool found = left_m <= near * enough_m;
  found ? state_.moving_forces.succeeded() : state_.moving_forces.failed();
  if (!found && moves_m_ > 0) return;  // those of the step before are nearer
  take(s, forces);
}

template <class Forces>
void SweptEquilibrium::take(IslandEquations& s, const Forces& forces) {
  auto& rows = s.sweeps.rows();
  for (std::size_t row = 0; row < rows.size(); ++row) rows[row].force = forces.force(row);
}

/// Forces found act at the trial, with their states.
void SweptEquilibrium::take_forces(IslandEquations& s) {
  const Trial now = trial_.now();
  const std::size_t contacts = s.island.contacts.size();
  const std::size_t supports = s.island.supports.size();
  s.actions.resize(contacts + supports + s.bolts.size());
  const auto& rows = s.sweeps.rows();
  for_each(contacts, [&](std::size_t i) {
    const int k = s.island.contacts[i];
    s.actions[i] = formulation_->take_contact(now, k, state_.contacts[at(k)], {rows[i].force, rows[i].slips});
  });
  for (std::size_t i = 0; i < supports; ++i) {
    const int k = s.island.supports[i];
    s.actions[contacts + i] = formulation_->take_support(now, k, state_.supports[at(k)], rows[contacts + i].force);
  }
  for (std::size_t i = 0; i < s.bolts.size(); ++i) {
    Interaction& action = s.actions[contacts + supports + i];
    action = interaction_of(now, state_.bolts[at(s.bolts[i])], model_.base.displacement(trial_.end_s));
    action.force = rows[contacts + supports + i].force;
  }
}

}  // namespace blockweir::solid
