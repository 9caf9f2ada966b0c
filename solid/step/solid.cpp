// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/step/initial_equilibrium.hpp"
#include "solid/step/step_errors.hpp"

namespace blockweir::solid {
namespace {

/// The longest step in which no block among others rotates farther than a contact search allows, with present
/// velocities [s]: a longer one would be undone. Static analyses have no velocities.
double until_turned(const Model& model, const State& state) {
  if (!model.is(scene::AnalysisKind::dynamic)) return std::numeric_limits<double>::infinity();
  double fastest = 0;
  for (const auto& [a, b] : state.search.near_pairs()) {
    for (const int block : {a, b}) {
      // A mesh turns by its triangles, whose third rate is no turn.
      if (model.parts.triangles[at(block)].empty())
        fastest = std::max(fastest, std::abs(state.blocks[at(block)].velocity[2]));
    }
  }
  return ContactSearch::most_turn / fastest;
}

/// Of a fall, by the outlines: contacts measure only what the search has seen, and leave out what strains give way.
/// Blocks that are in each other may go on into each other as they come to rest.
void look_at_overlaps(StepWorkspace& step) {
  if (!step.trial.falls() && (step.counts.overlap_m == 0 || step.trial.largest_increment() == 0)) return;
  const Stopwatch watch(step.profile.search);
  step.counts.overlap_m = step.state.search.overlap_m(step.state.placements, step.counts.overlap_m);
}

}  // namespace

void Solid::settle(const std::vector<Panel>& water) {
  starts_at_rest_ = InitialEquilibrium(step_, time_step_).settle(water) || from_rest_.starts_at_rest(water);
}

void Solid::advance(double from_s, double to_s, const std::vector<Panel>& water, const AddedMasses& masses) {
  PressureHistory held(0);
  held.add(from_s, water);
  std::vector<Eigen::Vector3d> velocities;
  for (std::size_t b = 0; b < model_.described(); ++b) velocities.push_back(state_.blocks[b].velocity.head<3>());
  advance(from_s, to_s, held, {masses, velocities, from_s});
}

void Solid::advance(double from_s, double to_s, PressureHistory& water, const Answered& answered) {
  if (model_.is(scene::AnalysisKind::at_rest)) return rest_.come_to_rest(water.at(to_s), to_s);
  const double largest_step = model_.scene.analysis.step_s;
  const double smallest_step = 1e-6 * largest_step;
  double time = from_s;
  for (ContactPoint& c : state_.contacts) c.slid = false;
  water_.begin_window(answered);
  if (!std::exchange(state_.started, true) && model_.scene.analysis.integrator != scene::Integrator::shi) {
    steps_.start_acceleration(water.at(from_s), from_s);
  }
  while (to_s - time > 1e-9 * largest_step) {
    step_.go_on();  // steps at rest solve nothing
    // Equal steps up to the end of the window, none longer than allowed; 1e-9 forgives round-off in the quotient.
    const double foreseen = std::max(smallest_step, until_turned(model_, state_));
    const double allowed = std::min({state_.next_dt, largest_step, foreseen});
    const double equal = (to_s - time) / std::ceil((to_s - time) / allowed * (1 - 1e-9));
    const double dt = std::abs(equal - allowed) <= 1e-9 * allowed ? allowed : equal;  // so that matrices stand
    const std::vector<Panel>& panels = water.at(time + dt);
    if (state_.guard.acts()) state_.guard.begin_step(water.weights(time + dt));
    if (!panels.empty()) {
      state_.water_work.begin_step(
          water_forces(panels, model_.blocks, state_.placements, model_.described(), model_.scene.water.nodal_rule),
          state_.guard, {state_.blocks, state_.placements, model_.water_motions});
    }
    from_rest_.begin_step(dt);
    const Outcome outcome = steps_.make({dt, time + dt, panels});
    if (outcome == Outcome::made) {
      from_rest_.end_step(dt, panels, time + dt);
      if (!panels.empty()) {
        state_.water_work.end_step(state_.guard, {state_.blocks, state_.placements, model_.water_motions}, dt,
                                   steps_.made_by_shi());
      }
      time += dt;
      state_.next_dt =
          std::min(largest_step, state_.next_dt < dt ? state_.next_dt * 2 : std::max(state_.next_dt, dt * 2));
      continue;
    }
    ++step_.counts.undone_steps;
    state_.next_dt = dt / 4;
    if (state_.next_dt < smallest_step) refuse_step(step_, time, dt, outcome);
  }
  look_at_overlaps(step_);
  // Steps without velocities move a slipping block a short way each: whether it stops is known at the window's end.
  constexpr double balanced = 5e-5;  // of the weight
  if (model_.is(scene::AnalysisKind::quasi_static) && rest_.unbalanced_ratio() > balanced) {
    rest_.come_to_rest(water.at(to_s), to_s);
  }
}

Counts Solid::counts() const {
  Counts counts = step_.counts;
  counts.state_changes = step_.formulation->progress().state_changes();
  counts.broad_searches = state_.search.broad_searches();
  return counts;
}

}  // namespace blockweir::solid
