// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/initial_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "solid/solve/islands.hpp"
#include "solid/step/step_errors.hpp"

namespace blockweir::solid {

std::vector<bool> unanchored(const Model& model, const State& state) {
  std::vector<std::pair<int, int>> links;
  for (const StrainCoupling& c : model.parts.couplings) links.emplace_back(c.i, c.j);
  for (const ContactPoint& c : state.contacts) {
    if (c.state != ContactState::open) links.emplace_back(c.vertex_part, c.edge_part);
  }
  std::vector<bool> waiting(model.blocks.size(), true);
  const auto anchor = [&](int b) { waiting[static_cast<std::size_t>(b)] = false; };
  for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
    if (model.blocks[static_cast<std::size_t>(b)].fixed) anchor(b);
  }
  for (const Support& s : state.supports) anchor(s.block);
  for (int b = 0; b < static_cast<int>(model.blocks.size()) && !model.boundary.empty(); ++b) {
    if (!model.boundary.hold(static_cast<std::size_t>(b)).isZero(0)) anchor(b);
  }
  for (const Bolt& bolt : state.bolts) {
    if (bolt.part[1] < 0) {
      anchor(bolt.part[0]);
    } else {
      links.emplace_back(bolt.part[0], bolt.part[1]);
    }
  }
  const auto is_anchored = [&](int b) { return !waiting[static_cast<std::size_t>(b)]; };
  for (const Island& group : find_islands(std::vector<bool>(model.blocks.size()), links, {})) {
    if (std::any_of(group.blocks.begin(), group.blocks.end(), is_anchored)) {
      std::for_each(group.blocks.begin(), group.blocks.end(), anchor);
    }
  }
  return waiting;
}

namespace {

/// Largest displacement of a vertex while bolts stretch to equilibrium [m]: their force is at most their yield or the
/// weight. With an oblique pull or a short lever it exceeds their elongation.
double moved_by_bolts_m(const Model& model, const State& state) {
  constexpr double farther = 4;
  double most = 0;
  for (const Bolt& bolt : state.bolts) {
    const scene::Bolt& d = *bolt.described;
    const double tension = d.yield_n_per_m.value_or(d.prestress_n_per_m + model.weight_n_per_m);
    most = std::max(most, farther * (tension - d.prestress_n_per_m) / d.stiffness_n_per_m2);
  }
  return most;
}

}  // namespace

bool InitialEquilibrium::settle(const std::vector<Panel>& water) {
  const Stretch pseudo_step{model_.pseudo_step_s(), model_.settling_time_s(), water};
  const std::vector<bool> fixed = trial_.frozen;
  const std::vector<BlockState> released = state_.blocks;
  const std::vector<bool> waiting = unanchored(model_, state_);
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) trial_.frozen[b] = fixed[b] || waiting[b];
  const StepMode mode{.scheme = {.damps = false}, .settles = true};
  const FormulationSettings usual = formulation_->settings();
  // Errors of the initial state remain as long as nothing moves: it is found ten times as accurately as a
  // step.
  FormulationSettings closely = usual;
  closely.force_tolerance_n *= 0.1;
  // Held joints have no states to find, so that large penalties cost nothing; small ones let a high stack sink by a
  // share of its rows squared.
  FormulationSettings held = closely;
  held.joints_held = true;
  held.penalty_ratio *= 100;
  held.closed_round_offs = 1;
  // Blocks with one strain that stick to each other all along fit only as well as their corners do: where these are
  // rounded, strains of some per cent at most leave this share of it apart.
  constexpr double misfit_ratio = 0.05;
  for (const ContactPoint& c : state_.contacts) {
    held.position_round_off_m = std::max(held.position_round_off_m, misfit_ratio * std::abs(c.gap_at_start));
  }
  time_step_.begin_anew();

  hold(pseudo_step, mode, held);
  closely.initial_penalty = held.initial_penalty;
  set(closely);
  const bool rests = relax(pseudo_step, mode);
  state_.whole_law = {};  // a step of the run is shorter by far
  set(usual);
  counts_.steps = 0;
  counts_.solved_islands = 0;  // what sleep saves is counted in steps of the run, which cost less
  profile_.equilibria = 0;
  trial_.frozen = fixed;
  state_.held_by_ground.clear();
  for (std::size_t b = 0; b < model_.blocks.size() && !model_.boundary.empty(); ++b) {
    state_.held_by_ground.emplace_back(-model_.boundary.hold(b) * state_.blocks[b].displacement);
  }
  time_step_.begin_anew();
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    state_.blocks[b].velocity = released[b].velocity;
    // Blocks that only waited, or were held while others settled, are not at rest.
    if (waiting[b] || !released[b].velocity.isZero(0)) state_.sleep.wake(b);
    state_.blocks[b].acceleration.setZero();
    state_.blocks[b].force.setZero();
  }
  return rests;
}

void InitialEquilibrium::set(const FormulationSettings& settings) {
  formulation_->settings() = settings;
  if (step_.substitute) step_.substitute->settings() = settings;
}

/// Steps with all joints held, until nothing moves.
void InitialEquilibrium::hold(const Stretch& pseudo_step, const StepMode& mode, FormulationSettings& held) {
  constexpr int most_steps = 200;
  const double at_rest_m = 1e-13 * model_.size_m;
  const double shortest = 1e-6 * pseudo_step.dt;
  set(held);
  // Slender structures are soft compared with the inertia of such steps and relax by a tenth at a time: longer steps
  // are faster.
  double dt = pseudo_step.dt;
  double longest = 100 * pseudo_step.dt;
  double moved_before = std::numeric_limits<double>::infinity();
  Outcome last = Outcome::not_found;
  const auto solves = [&] {
    const Stretch stretch{dt, pseudo_step.end_s, pseudo_step.water};
    last = time_step_.attempt(stretch, mode);
    if (step_.substitute && last == Outcome::not_found) last = methods_.try_by_substitute(stretch, mode);
    return last == Outcome::made;
  };
  const auto settles = [&] {
    if (solves()) return true;
    if (dt > pseudo_step.dt) {
      longest = dt = pseudo_step.dt;
      if (solves()) return true;
    }
    // Soft structures move by as much as a step may, restrained by inertia.
    while (last == Outcome::too_far && dt > shortest) {
      dt /= 4;
      if (solves()) return true;
    }
    if (held.initial_penalty) {
      // What the scene starts with may be far too small for a high stack: the blocks' own stiffness knows better.
      held.initial_penalty = std::nullopt;
      set(held);
      if (solves()) return true;
    }
    // Gaps may hover just above round-off, or close so slowly that joints would lock: both are nothing.
    for (const double round_offs : {4.0, 4e3}) {
      held.closed_round_offs = round_offs;
      set(held);
      if (solves()) return true;
    }
    return false;
  };
  for (int step = 0;; ++step) {
    state_.stop();
    if (step == most_steps || !settles()) refuse_start(step_, step, most_steps, last);
    ++counts_.settling_steps;
    require_small_strains(step_);
    const double moved = trial_.largest_increment();
    if (moved <= at_rest_m && dt >= pseudo_step.dt) return;
    if (dt > pseudo_step.dt && moved > moved_before) {
      longest = dt = pseudo_step.dt;  // what is loose wants its inertia
    } else if (dt < pseudo_step.dt || moved > 1e-2 * moved_before) {
      dt = std::min(10 * dt, dt < pseudo_step.dt ? pseudo_step.dt : longest);
    }
    moved_before = moved;
  }
}

/// Shear that the joints' own laws cannot carry slips while settling, so that its release does not make the blocks
/// oscillate. If all joints of a high stack slip at once, both ends of each in opposite directions, hardly anything
/// holds the blocks sideways: shorter steps, whose inertia does, find the states, and come at least close to
/// equilibrium. A structure that does not is already moving: it starts from the held state.
bool InitialEquilibrium::relax(const Stretch& pseudo_step, const StepMode& mode) {
  constexpr int most_steps = 200;
  const Standing held = state_;
  // What moves by more at once than the blocks' own strains have moved it, or bolts let it, is on its way.
  const double far_m =
      std::max({1e-4 * model_.size_m, state_.largest_displacement_m(model_), moved_by_bolts_m(model_, state_)});
  const double slips_m = model_.scene.analysis.failure_displacement_m + state_.largest_displacement_m(model_);
  const double at_rest_m = 1e-12 * model_.size_m;
  const double shortest = 1e-4 * pseudo_step.dt;
  const double moving = 1e-4 * model_.scene.analysis.gravity_m_per_s2;
  double dt = pseudo_step.dt;
  double longest = 100 * pseudo_step.dt;
  double failed = longest;  // a step that found no states
  Backoff as_long;          // as it again
  double acceleration = std::numeric_limits<double>::infinity();
  int steady_steps = 0;
  for (int step = 0; step < most_steps && dt > shortest; ++step) {
    state_.stop();
    const bool whole_step = dt >= pseudo_step.dt;
    const Stretch stretch{dt, pseudo_step.end_s, pseudo_step.water};
    const auto solved = [&] {
      if (dt > pseudo_step.dt) return methods_.try_with_lagging_friction(stretch, mode);
      if (whole_step) return methods_.try_all(stretch, mode);
      const Outcome outcome = time_step_.attempt(stretch, mode);
      return outcome == Outcome::not_found ? methods_.try_softly(stretch, mode) : outcome;
    };
    if (solved() != Outcome::made) {
      if (dt > pseudo_step.dt) {
        longest = std::max(pseudo_step.dt, longest / 10);
        dt = pseudo_step.dt;
      } else {
        as_long.failed();
        failed = dt;
        dt /= 4;
      }
      continue;
    }
    ++counts_.settling_steps;
    const double moved = trial_.largest_increment();
    // Whatever stops it then, it was not stable as drawn.
    if (state_.largest_slip_m() > slips_m) break;
    if (moved <= at_rest_m && whole_step) return true;
    const double before = std::exchange(acceleration, 2 * moved / (dt * dt));
    // A motion that changes by less than a thousandth in a step will not stop in the remaining steps.
    steady_steps = std::abs(acceleration / before - 1) <= 1e-3 ? steady_steps + 1 : 0;
    // A static analysis follows creep by growing steps, and decides sooner.
    if (steady_steps == 5 && (acceleration >= moving || model_.is(scene::AnalysisKind::at_rest))) break;
    if (moved > far_m) break;
    // Large structures relax by a tenth at a time: longer steps, if they find states, are faster.
    const bool comes_to_rest = state_.whole_law.after_failure() && whole_step && moved <= 1e-6 * model_.size_m;
    const double longer = comes_to_rest ? longest : std::min(pseudo_step.dt, 2 * dt);
    if (longer <= dt || longer < failed || !as_long.skips()) dt = longer;
  }
  if (acceleration < moving && state_.largest_slip_m() <= slips_m) return true;
  state_.restore(held);
  forget_locked_forces();
  start_moving(pseudo_step, acceleration, Standing(state_), mode);
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) state_.sleep.wake(b);
  return false;
}

/// Held, blocks with one strain may lock each other by forces many times the weight of all. A step in motion that
/// begins with these throws the blocks.
void InitialEquilibrium::forget_locked_forces() {
  constexpr double many = 5;
  const auto locked = [this](const ContactPoint& c) { return c.force.norm() > many * model_.weight_n_per_m; };
  if (std::none_of(state_.contacts.begin(), state_.contacts.end(), locked)) return;
  for (ContactPoint& c : state_.contacts) {
    c.force.setZero();
    c.multiplier.setZero();
  }
}

/// The strains at the start of a motion, found in steps so short that there is hardly any displacement: released at
/// once, forces held beyond the joints' laws would give the blocks a push. Rigid blocks have no strains, and blocks so
/// soft that these steps would carry them off start from the held state.
void InitialEquilibrium::start_moving(const Stretch& pseudo_step, double acceleration, const Standing& held,
                                      const StepMode& mode) {
  constexpr int steps = 5;
  constexpr double brief = 0.02;   // of the pseudo-step: a fifth of what strains lack is left by each
  constexpr double hardly = 0.02;  // of a failure
  const double dt = brief * pseudo_step.dt;
  const bool carried_off = steps * acceleration * dt * dt / 2 > hardly * model_.scene.analysis.failure_displacement_m;
  bool any_strains = false;
  for (std::size_t b = 0; b < model_.blocks.size(); ++b)
    any_strains = any_strains || !(trial_.frozen[b] || model_.blocks[b].rigid);
  if (!any_strains || carried_off) return;
  for (int step = 0; step < steps; ++step) {
    state_.stop();
    if (time_step_.attempt({dt, pseudo_step.end_s, pseudo_step.water}, mode) != Outcome::made)
      return state_.restore(held);
    ++counts_.settling_steps;
  }
}

}  // namespace blockweir::solid
