// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/newton.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/results/stopwatch.hpp"
#include "solid/contact/bonds.hpp"
#include "solid/step/equilibrium.hpp"
#include "solid/step/step_errors.hpp"
#include "solid/step/temporarily.hpp"

namespace blockweir::solid {
namespace {

constexpr int few_at_rest = 24;  ///< unknowns of an island whose solutions cost almost nothing

/// Detects iterates that diverge: twice in a row the imbalance is far larger than at first. Of 1,008 states found in
/// islands above 60 unknowns none was found after that.
class Divergence {
 public:
  bool found(double unbalanced, double first) {
    constexpr double far = 1e5;
    times_ = unbalanced > far * first ? times_ + 1 : 0;
    return times_ > 1;
  }

 private:
  int times_ = 0;
};

/// Detects cycles of Newton's method: an imbalance occurs again (Brent's cycle detection).
class Circle {
 public:
  bool closes(double unbalanced) {
    if (std::abs(unbalanced - seen_) <= 1e-9 * seen_) return true;
    if (++since_ == wait_) {
      seen_ = unbalanced;
      wait_ *= 2;
      since_ = 0;
    }
    return false;
  }

 private:
  double seen_ = -1;
  int since_ = 0;
  int wait_ = 1;
};

}  // namespace

/// Number of solutions for an island. If sweeps can follow, or the fallbacks of a static analysis, more than 40 hardly
/// ever find a state of a medium island (NUMERICS.md). After a failure the next attempt is short; for falling blocks
/// sweeps get as close sooner.
int Newton::turn(int unknowns, const StepMode& mode) const {
  const int most = model_.scene.contact.max_iterations;
  const bool sweeps = may_sweep(step_, mode);
  const bool falls = sweeps && trial_.falls();
  const bool has_failed = state_.whole_law.after_failure();
  constexpr int enough = 40;
  // A smooth step keeps its states: where it has not found them soon, they change.
  constexpr int states_known = 20;
  if (mode.smooth_only && unknowns > few_unknowns && trial_.falls()) return std::min(most, states_known);
  if (!sweeps && unknowns <= large_island) {
    // The states of held joints are known, and no other method would find their forces.
    const bool others_follow = model_.is(scene::AnalysisKind::at_rest) && !formulation_->settings().joints_held;
    return others_follow && unknowns > few_at_rest ? std::min(most, enough) : most;
  }
  if (unknowns <= few_unknowns) return falls && has_failed ? std::min(most, 20) : most;
  if (has_failed) return std::min(most, falls ? 3 : 20);
  return sweeps ? std::min(most, enough) : most;
}

bool Newton::find(IslandEquations& s, const StepMode& mode) {
  // A large island whose states run in circles shows it by then; trying on costs a small one little, and may find out.
  // In the largest a solution costs several of those by Cholesky that find states while friction lags.
  const int unknowns = s.unknowns->total;
  const int most_in_a_row = unknowns > 10 * large_island ? 15
                            : unknowns > large_island    ? 50
                                                         : model_.scene.contact.max_iterations;
  const int most = turn(unknowns, mode);
  const double tolerance = formulation_->settings().force_tolerance_n;
  constexpr double close = 0.3;  // of what multipliers will still move: they need no closer equilibrium
  const IslandContacts contacts = s.island_contacts();
  int in_a_row = 0;  // solves since the last sweep
  double first = 0;  // unbalanced as they began
  Circle circle;
  Divergence divergence;
  const bool others_follow = unknowns > few_unknowns && may_sweep(step_, mode);
  for (int iteration = 0; iteration < most; ++iteration) {
    const double left = s.unbalanced();
    if (!std::isfinite(left)) {
      // What iterates make of it is another method's; so it is with the forces of redundant multipliers.
      if (iteration == 0 && formulation_->force_constraints() == nullptr) require_numbers(step_, s);
      return false;
    }
    if (left <= tolerance || left <= close * formulation_->unsettled(contacts)) {
      if (update_multipliers(s)) return true;
      circle = {};
      in_a_row = 0;
      first = unbalanced_in_these_states(s, mode);
    } else if (iteration > 0) {
      if (circle.closes(left)) return false;
      if (divergence.found(left, std::max(first, tolerance)) && others_follow) return false;
      ++in_a_row;
    } else {
      first = left;
    }
    const bool diverges = unknowns > 10 * large_island && in_a_row > 2 && left > 1e3 * first;
    if (diverges || in_a_row > most_in_a_row || !s.solve_linearized()) return false;
    s.move(1);
  }
  return false;
}

/// Multipliers that replaced the penalties' part disturb the balance, but no states. A solution with the present states
/// avoids one in which hundreds of them would change and change back. While a structure settles all are checked:
/// otherwise a contact that slipped once would continue, and bonds that can hold it would break.
double Newton::unbalanced_in_these_states(IslandEquations& s, const StepMode& mode) {
  const Temporarily stand(formulation_->settings().states_stand, !mode.settles);
  return s.unbalanced();
}

/// Multipliers (8), then bonds: false where one of them has changed.
bool Newton::update_multipliers(IslandEquations& s) {
  const Stopwatch watch(profile_.sweeps);
  ++counts_.sweeps;
  return formulation_->sweep(s.island_contacts()) &&
         (formulation_->settings().joints_held || !break_bonds(model_.laws, formulation_->settings().force_tolerance_n,
                                                               model_.blocks, s.island.contacts, state_.contacts));
}

}  // namespace blockweir::solid
