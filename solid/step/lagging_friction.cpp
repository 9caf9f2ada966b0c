// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/lagging_friction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "bridge/results/stopwatch.hpp"
#include "solid/contact/bonds.hpp"
#include "solid/contact/interior_point.hpp"
#include "solid/step/newton.hpp"
#include "solid/step/restore_unless.hpp"
#include "solid/step/step_errors.hpp"
#include "solid/step/temporarily.hpp"

namespace blockweir::solid {

bool LaggingFriction::find(IslandEquations& s, const StepMode& mode) {
  const IslandContacts contacts = s.island_contacts();
  constexpr int few_solutions = 3;
  formulation_->lagged_friction()->begin(contacts);
  // A step after one whose friction lagged begins with its states, or nearly so.
  const bool goes_on = state_.whole_law.after_failure();
  if (!goes_on || !restore_unless(step_, s, mode, [&] { return minimize(s, few_solutions); })) {
    const double left = mode.settles && goes_on ? s.unbalanced() : std::numeric_limits<double>::infinity();
    const Approach reached = approach(s, left);
    if (mode.settles && reached == Approach::near && finish(s, mode)) return true;
    // Softer contacts or a shorter step are cheaper than sweeps from here.
    if (mode.settles && reached == Approach::nothing) return false;
  }
  for (int sweep = 0; sweep < model_.scene.contact.max_iterations; ++sweep) {
    const bool bounds_stand = formulation_->lagged_friction()->follow(contacts, formulation_->progress(),
                                                                      formulation_->settings().force_tolerance_n);
    if (!minimize(s, model_.scene.contact.max_iterations)) return false;
    const Stopwatch watch(profile_.sweeps);
    ++counts_.sweeps;
    const bool settled = formulation_->sweep(contacts) && bounds_stand;
    if (settled && !break_bonds(model_.laws, formulation_->settings().force_tolerance_n, model_.blocks,
                                s.island.contacts, state_.contacts))
      return true;
  }
  return false;
}

/// If hundreds of contacts slip or open at once, Newton's method would need hundreds of solutions for
/// their states. It, or sweeps, complete what this method leaves; if this method does not get close, they
/// start as without it. Among thousands of deformable bricks some contacts with almost no force
/// alternate: the result is then the closest state. Forces of the step before will change by about
/// `change_n`.
LaggingFriction::Approach LaggingFriction::approach(IslandEquations& s, double change_n) {
  constexpr int most_solutions = 200;
  constexpr double near = 1e-5;  // of what was unbalanced
  constexpr int patience = 8;
  const IslandContacts contacts = s.island_contacts();
  std::unique_ptr<Formulation> other = std::make_unique<InteriorPoint>(model_.laws, formulation_->settings(), change_n);
  auto& method = static_cast<InteriorPoint&>(*other);
  method.begin(trial_.now(), trial_.matrix, trial_.frozen, contacts);
  double first = method.scale_n();
  const TradePlaces stands_in(formulation_, other);
  Eigen::VectorXd way = Eigen::VectorXd::Zero(s.unknowns->total);
  Eigen::VectorXd best = way;  // where least was left
  double least = std::numeric_limits<double>::infinity();
  double halved = least;
  int since = 0;  // solutions that have not halved that again
  Approach reached = Approach::nothing;
  for (int solutions = 0; solutions < most_solutions; ++solutions) {
    const double left = s.unbalanced();
    if (solutions == 0) first = std::max(first, left);
    since = left <= halved / 2 ? 0 : since + 1;
    if (since == 0) halved = left;
    if (left < least) {
      least = left;
      const double tolerance = method.settings().force_tolerance_n;
      reached = left <= tolerance ? Approach::states : left <= near * first ? Approach::near : Approach::nothing;
      if (reached != Approach::nothing) {
        best = way;
        method.hand_over(contacts);
      }
    }
    const bool done = reached == Approach::states || (reached == Approach::near && since >= patience);
    if (done || !(left <= 1e6 * first) || !s.solve_linearized()) break;
    s.move(1);
    method.predict(trial_.now(), contacts);
    s.move(-1);
    s.unbalanced();
    if (!s.solve(true)) break;
    ++counts_.iterations;
    s.move(1);
    const double fraction = method.follow_correction(trial_.now(), contacts);
    s.move(fraction - 1);
    way += fraction * s.correction;
  }
  s.correction = best - way;
  s.move(1);
  return reached;
}

/// From states that are next to right Newton's method on the whole of Coulomb's law takes a few solutions, by penalties
/// as large as a step's own. Where bricks that carry little slip at both ends, bounds that lag may go to and fro for
/// ever.
bool LaggingFriction::finish(IslandEquations& s, const StepMode& mode) {
  FormulationSettings& settings = formulation_->settings();
  const auto by_whole_law = [&] {
    s.unbalanced();  // by bounds that lag: which way contacts slip
    for (const int k : s.island.contacts) state_.contacts[static_cast<std::size_t>(k)].penalty /= lagging_penalty_ratio;
    for (const int k : s.island.supports) state_.supports[static_cast<std::size_t>(k)].penalty /= lagging_penalty_ratio;
    const Temporarily harder(settings.penalty_ratio, settings.penalty_ratio / lagging_penalty_ratio);
    const Temporarily follows(settings.friction_lags, false);
    return Newton(step_).find(s, mode.by_whole_law());
  };
  return restore_unless(step_, s, mode, by_whole_law);
}

/// Of the energy whose negative gradient is the residual.
bool LaggingFriction::minimize(IslandEquations& s, int most_solutions) {
  double left = s.unbalanced();
  for (int iteration = 0; iteration < most_solutions; ++iteration) {
    if (left <= formulation_->settings().force_tolerance_n) return true;
    if (!std::isfinite(left)) {
      require_numbers(step_, s);
      return false;
    }
    if (!s.solve_linearized()) return false;
    left = search_along_correction(s);
  }
  return false;
}

/// Takes the whole correction, or as much of it as halves the slope of the energy where that has become as steep
/// upward: by regula falsi and bisection in turns, for the slope has kinks. Returns the largest unbalanced force.
double LaggingFriction::search_along_correction(IslandEquations& s) {
  constexpr int most = 40;
  struct Place {
    double fraction;
    double slope;  // of the energy, downward
  };
  Place low{0, s.residual.dot(s.correction)};
  const double enough = low.slope / 2;
  double left = 0;
  const auto go_to = [&](double fraction, double from) {
    s.move(fraction - from);
    left = s.unbalanced();
    return Place{fraction, s.residual.dot(s.correction)};
  };
  Place high = go_to(1, 0);
  Place here = high;
  if (here.slope >= -enough) return left;
  for (int k = 0; k < most && std::abs(here.slope) > enough && left > formulation_->settings().force_tolerance_n; ++k) {
    const double share = k % 2 == 0 ? low.slope / (low.slope - high.slope) : 0.5;
    here = go_to(low.fraction + share * (high.fraction - low.fraction), here.fraction);
    (here.slope > 0 ? low : high) = here;
  }
  return left;
}

}  // namespace blockweir::solid
