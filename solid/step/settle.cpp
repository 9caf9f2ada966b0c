// SPDX-License-Identifier: GPL-3.0-or-later
// The state at time 0: weight and first loads carried, all joints that touch held, everything at rest.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Blocks that hang on nothing: no chain of touching contacts and bolts leads to the ground or to a support.
std::vector<bool> Solid::unanchored() const {
  std::vector<std::pair<int, int>> links;
  for (const StrainCoupling& c : parts_.couplings) links.emplace_back(c.i, c.j);
  for (const ContactPoint& c : contacts_) {
    if (c.state != ContactState::open) links.emplace_back(c.vertex_part, c.edge_part);
  }
  std::vector<bool> waiting(blocks_.size(), true);
  const auto anchor = [&](int b) { waiting[static_cast<std::size_t>(b)] = false; };
  for (int b = 0; b < static_cast<int>(blocks_.size()); ++b) {
    if (blocks_[static_cast<std::size_t>(b)].fixed) anchor(b);
  }
  for (const Support& s : supports_) anchor(s.block);
  for (const Bolt& bolt : bolts_) {
    if (bolt.part[1] < 0) {
      anchor(bolt.part[0]);
    } else {
      links.emplace_back(bolt.part[0], bolt.part[1]);
    }
  }
  const auto is_anchored = [&](int b) { return !waiting[static_cast<std::size_t>(b)]; };
  for (const Island& group : find_islands(std::vector<bool>(blocks_.size()), links, {})) {
    if (std::any_of(group.blocks.begin(), group.blocks.end(), is_anchored)) {
      std::for_each(group.blocks.begin(), group.blocks.end(), anchor);
    }
  }
  return waiting;
}

/// Long against every elastic period, so that inertia only regularizes: 2 M/dt^2 is 1e-4 of the elastic modulus.
double Solid::pseudo_step_s() const {
  double longest = 0;
  for (const Block& block : blocks_) {
    if (block.fixed) continue;
    const double modulus = block.stiffness(0, 0) / block.area;
    if (modulus > 0) longest = std::max(longest, std::sqrt(2e4 * block.mass_per_m() / modulus));
  }
  return longest;
}

/// The time whose loads settle: a static analysis has those of its end.
double Solid::settling_time_s() const {
  return scene_.analysis.kind == scene::AnalysisKind::at_rest ? scene_.analysis.duration_s : 0;
}

Solid::Standing Solid::standing() const {
  return {states_, start_, contacts_, supports_, bolts_};
}

void Solid::stand_as(const Standing& before) {
  states_ = before.states;
  start_ = before.start;
  contacts_ = before.contacts;
  supports_ = before.supports;
  bolts_ = before.bolts;
  contacts_stand_ = false;
}

void Solid::settle(const std::vector<Panel>& water) {
  constexpr int most_steps = most_settling_steps;
  const double pseudo_step = pseudo_step_s();
  const double at_rest_m = 1e-13 * size_;
  const double shortest = 1e-6 * pseudo_step;

  const std::vector<bool> fixed = frozen_;
  const std::vector<BlockState> released = states_;
  const std::vector<bool> waiting = unanchored();
  for (std::size_t b = 0; b < blocks_.size(); ++b) frozen_[b] = fixed[b] || waiting[b];
  const StepMode mode{.scheme = {.damps = false}, .settles = true};
  const FormulationSettings usual = formulation_->settings();
  const auto set = [this](const FormulationSettings& settings) {
    formulation_->settings() = settings;
    if (substitute_) substitute_->settings() = settings;
  };
  // What the start leaves unbalanced or apart stays as long as nothing moves: it is found ten times as closely as a
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
  for (const ContactPoint& c : contacts_) {
    held.position_round_off_m = std::max(held.position_round_off_m, misfit_ratio * std::abs(c.gap_at_start));
  }
  set(held);
  matrices_dt_ = -1;
  islands_.clear();

  // Slender structures are soft against the inertia of such steps and come to rest a tenth at a time: longer steps take
  // them there sooner.
  double dt = pseudo_step;
  double longest = 100 * pseudo_step;
  double moved_before = std::numeric_limits<double>::infinity();
  Outcome last = Outcome::not_found;
  const auto solves = [&] {
    const Stretch stretch{dt, settling_time_s(), water};
    last = attempt(stretch, mode);
    if (substitute_ && last == Outcome::not_found) last = attempt_by_substitute(stretch, mode);
    return last == Outcome::made;
  };
  const auto settles = [&] {
    if (solves()) return true;
    if (dt > pseudo_step) {
      longest = dt = pseudo_step;
      if (solves()) return true;
    }
    // What is soft goes on by as much as a step may, held back by its inertia.
    while (last == Outcome::too_far && dt > shortest) {
      dt /= 4;
      if (solves()) return true;
    }
    if (!held.initial_penalty) return false;
    // What the scene starts with may be far too small for a high stack: the blocks' own stiffness knows better.
    held.initial_penalty = closely.initial_penalty = std::nullopt;
    set(held);
    return solves();
  };
  for (int step = 0;; ++step) {
    for (BlockState& state : states_) state.velocity.setZero(), state.acceleration.setZero();
    if (step == most_steps || !settles()) refuse_start(step, last);
    ++counts_.settling_steps;
    require_small_strains();
    const double moved = largest_increment();
    if (moved <= at_rest_m && dt >= pseudo_step) break;
    if (dt > pseudo_step && moved > moved_before) {
      longest = dt = pseudo_step;  // what is loose wants its inertia
    } else if (dt < pseudo_step || moved > 1e-2 * moved_before) {
      dt = std::min(10 * dt, dt < pseudo_step ? pseudo_step : longest);
    }
    moved_before = moved;
  }

  set(closely);
  relax({pseudo_step, settling_time_s(), water}, mode);
  whole_law_ = {};  // a step of the run is shorter by far
  set(usual);
  counts_.steps = 0;
  counts_.solved_islands = 0;  // what sleep saves is counted in steps of the run, which cost less
  profile_.equilibria = 0;
  frozen_ = fixed;
  matrices_dt_ = -1;
  islands_.clear();
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    states_[b].velocity = released[b].velocity;
    // What has only waited, or stood still for the others to settle, does not rest.
    if (waiting[b] || !released[b].velocity.isZero(0)) sleep_.wake(b);
    states_[b].acceleration.setZero();
    states_[b].force.setZero();
  }
}

/// Shear that joints cannot carry by their own laws slips away at rest, so that its release does not set the blocks
/// ringing. Where all joints of a high stack slip at once, both ends of each in opposite directions, next to nothing
/// holds the blocks sideways: shorter steps, whose inertia does, find the states, and come at least near to rest. A
/// structure that does not is on the move already: it starts from the held state.
void Solid::relax(const Stretch& pseudo_step, const StepMode& mode) {
  constexpr int most_steps = 200;
  const Standing held = standing();
  // What moves by more at once than the blocks' own strains have moved it is on its way.
  const double far_m = std::max(1e-4 * size_, largest_displacement_m());
  const double at_rest_m = 1e-12 * size_;
  const double shortest = 1e-4 * pseudo_step.dt;
  const double moving = 1e-4 * scene_.analysis.gravity_m_per_s2;
  double dt = pseudo_step.dt;
  double longest = 100 * pseudo_step.dt;
  double failed = longest;  // a step that found no states
  Pause as_long;            // as it again
  double acceleration = std::numeric_limits<double>::infinity();
  int steady_steps = 0;
  for (int step = 0; step < most_steps && dt > shortest; ++step) {
    for (BlockState& state : states_) state.velocity.setZero(), state.acceleration.setZero();
    const bool whole_step = dt >= pseudo_step.dt;
    const Stretch stretch{dt, pseudo_step.end_s, pseudo_step.water};
    const auto solved = [&] {
      if (dt > pseudo_step.dt) return attempt_with_lagging_friction(stretch, mode);
      if (whole_step) return try_step(stretch, mode);
      const Outcome outcome = attempt(stretch, mode);
      return outcome == Outcome::not_found ? attempt_softly(stretch, mode) : outcome;
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
    const double moved = largest_increment();
    if (moved <= at_rest_m && whole_step) return;
    const double before = std::exchange(acceleration, 2 * moved / (dt * dt));
    // What changes by less than a thousandth a step does not come to rest in those that are left.
    steady_steps = std::abs(acceleration / before - 1) <= 1e-3 ? steady_steps + 1 : 0;
    if (steady_steps == 5 && acceleration >= moving) break;
    if (moved > far_m) break;
    // Large structures come to rest a tenth at a time: longer steps, where they find states, take them there sooner.
    const bool comes_to_rest = whole_law_.after_failure() && whole_step && moved <= 1e-6 * size_;
    const double longer = comes_to_rest ? longest : std::min(pseudo_step.dt, 2 * dt);
    if (longer <= dt || longer < failed || !as_long.skips()) dt = longer;
  }
  if (acceleration < moving) return;
  starts_at_rest_ = false;
  stand_as(held);
  start_moving(pseudo_step, acceleration, held, mode);
  for (std::size_t b = 0; b < blocks_.size(); ++b) sleep_.wake(b);
}

/// The strains of the motion that begins, found in steps so short that it hardly moves: released at once, what joints
/// have held beyond their laws would give it a push. What does not strain has none, and what is so soft that these
/// steps would carry it off starts as it was held.
void Solid::start_moving(const Stretch& pseudo_step, double acceleration, const Standing& held, const StepMode& mode) {
  constexpr int steps = 5;
  constexpr double brief = 0.02;   // of the pseudo-step: a fifth of what strains lack is left by each
  constexpr double hardly = 0.02;  // of a failure
  const double dt = brief * pseudo_step.dt;
  const bool carried_off = steps * acceleration * dt * dt / 2 > hardly * scene_.analysis.failure_displacement_m;
  bool any_strains = false;
  for (std::size_t b = 0; b < blocks_.size(); ++b) any_strains = any_strains || !(frozen_[b] || blocks_[b].rigid);
  if (!any_strains || carried_off) return;
  for (int step = 0; step < steps; ++step) {
    for (BlockState& state : states_) state.velocity.setZero(), state.acceleration.setZero();
    if (attempt({dt, pseudo_step.end_s, pseudo_step.water}, mode) != Outcome::made) return stand_as(held);
    ++counts_.settling_steps;
  }
}

/// Second-order schemes need the acceleration that the run starts with: a step of Shi's scheme, undone, gives it.
void Solid::start_acceleration(const std::vector<Panel>& water, double from_s) {
  const Standing before = standing();
  const double dt = 1e-2 * scene_.analysis.step_s;
  const bool solved = attempt({dt, from_s + dt, water}, {}) == Outcome::made;
  auto first = states_;
  stand_as(before);
  smooth_steps_ = solved ? smooth_steps_before_restart : 0;
  if (!solved) return;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    states_[b].acceleration = first[b].acceleration;
    // With water to push a mesh has inertia beyond its triangles' own: what balanced it is the force.
    states_[b].force = mean_motions_.empty() ? Vector6(inertia(b) * first[b].acceleration) : first[b].force;
  }
}

}  // namespace blockweir::solid
