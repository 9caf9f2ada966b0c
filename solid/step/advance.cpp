// SPDX-License-Identifier: GPL-3.0-or-later
// The time step as an algorithm: search, assemble, solve, open-close, accept or cut, update.
#include <algorithm>
#include <cmath>
#include <utility>

#include "bridge/results/stopwatch.hpp"
#include "solid/block/parallel.hpp"
#include "solid/step/solid.hpp"
#include "solid/step/temporarily.hpp"

namespace blockweir::solid {
namespace {

// Of a fall through the step: closed in one, an overlap gets a velocity of that share of the fall's.
constexpr double lasting_overlap = 5e-5;

}  // namespace

void Solid::advance(double from_s, double to_s, const std::vector<Panel>& water, const AddedMasses& masses) {
  WaterCourse held(0);
  held.add(from_s, water);
  std::vector<Eigen::Vector3d> velocities;
  for (std::size_t b = 0; b < described(); ++b) velocities.push_back(states_[b].velocity.head<3>());
  advance(from_s, to_s, held, {masses, velocities, from_s});
}

void Solid::advance(double from_s, double to_s, WaterCourse& water, const Answered& answered) {
  if (scene_.analysis.kind == scene::AnalysisKind::at_rest) return come_to_rest(water.at(to_s), to_s);
  const double largest_step = scene_.analysis.step_s;
  const double smallest_step = 1e-6 * largest_step;
  double time = from_s;
  for (ContactPoint& c : contacts_) c.slid = false;
  loads_.start_base();
  begin_window(answered);
  if (!std::exchange(started_, true) && scene_.analysis.integrator != scene::Integrator::shi) {
    start_acceleration(water.at(from_s), from_s);
  }
  while (to_s - time > 1e-9 * largest_step) {
    if (meanwhile_) meanwhile_();  // steps at rest solve nothing
    // Equal steps up to the end of the window, none longer than allowed; 1e-9 forgives round-off in the quotient.
    const double allowed = std::min(next_dt_, largest_step);
    const double equal = (to_s - time) / std::ceil((to_s - time) / allowed * (1 - 1e-9));
    const double dt = std::abs(equal - allowed) <= 1e-9 * allowed ? allowed : equal;  // so that matrices stand
    const std::vector<Panel>& panels = water.at(time + dt);
    if (guard_.acts()) guard_.begin_step(water.weights(time + dt));
    if (!panels.empty()) {
      water_work_.begin_step(water_forces(panels, blocks_, start_, described(), scene_.water.nodal_rule), guard_,
                             states_);
    }
    const Outcome outcome = make_step({dt, time + dt, panels});
    if (outcome == Outcome::made) {
      if (!panels.empty()) water_work_.end_step(guard_, states_, dt, made_by_shi_);
      time += dt;
      next_dt_ = std::min(largest_step, next_dt_ < dt ? next_dt_ * 2 : std::max(next_dt_, dt * 2));
      continue;
    }
    ++counts_.undone_steps;
    next_dt_ = dt / 4;
    if (next_dt_ < smallest_step) refuse_step(time, dt, outcome);
  }
  // Steps without velocities take what slips a short way each: whether it comes to rest is seen at the window's end.
  constexpr double balanced = 5e-5;  // of the weight
  if (scene_.analysis.kind == scene::AnalysisKind::quasi_static && unbalanced_ratio() > balanced) {
    come_to_rest(water.at(to_s), to_s);
  }
}

/// In motion contacts are swept where Newton's method does not find their states. A state of rest is to be exact: where
/// the whole of Coulomb's law runs in circles there, friction lags, and is left to for a while. Where contacts are
/// redundant, states of Lagrange multipliers run in circles: the augmented Lagrangian makes such a step. Where a bond
/// is about to break on the way to rest and no states are found with it or without, contacts are swept as well.
Outcome Solid::try_step(const Stretch& stretch, const StepMode& mode) {
  const auto lagging = [&] { return attempt_with_lagging_friction(stretch, mode); };
  if (!mode.in_motion() && whole_law_.skips() && lagging() == Outcome::made) return Outcome::made;
  Outcome outcome = attempt(stretch, mode);
  if (!mode.in_motion() && outcome == Outcome::made) whole_law_.succeeded();
  if (outcome != Outcome::not_found) return outcome;
  if (substitute_) return attempt_by_substitute(stretch, mode);
  if (mode.in_motion()) return outcome;
  const auto large = [](const IslandSystem& s) { return s.unknowns->total > large_island; };
  if (std::none_of(islands_.begin(), islands_.end(), large)) {
    outcome = attempt_softly(stretch, mode);
    if (outcome == Outcome::not_found) outcome = attempt(stretch, mode.with_pivoting());
  }
  if (outcome == Outcome::not_found) {
    outcome = lagging();
    if (outcome == Outcome::made) whole_law_.failed();
  }
  if (outcome != Outcome::not_found || mode.settles) return outcome;
  return attempt(stretch, mode.with_sweeps());
}

/// A large penalty leaves a sticking contact a narrow range of slips, in which Newton's method may jump to and fro
/// between states; a smaller one takes more sweeps of multipliers. Of small structures, which friction that lags serves
/// badly.
Outcome Solid::attempt_softly(const Stretch& stretch, const StepMode& mode) {
  Outcome outcome = Outcome::not_found;
  if (!formulation_->can_lag_friction()) return outcome;  // has no penalties of its own
  double& penalty_ratio = formulation_->settings().penalty_ratio;
  const double usual = penalty_ratio;
  for (double ratio = usual / 100; outcome == Outcome::not_found && ratio >= usual / 1e6; ratio /= 100) {
    ++counts_.softened_steps;
    const Temporarily softer(penalty_ratio, ratio);
    outcome = attempt(stretch, mode);
  }
  return outcome;
}

Outcome Solid::attempt_with_lagging_friction(const Stretch& stretch, const StepMode& mode) {
  if (!formulation_->can_lag_friction()) return Outcome::not_found;
  FormulationSettings& settings = formulation_->settings();
  ++counts_.lagged_steps;
  const Temporarily softer(settings.penalty_ratio, lagging_penalty_ratio * settings.penalty_ratio);
  const Temporarily lags(settings.friction_lags, true);
  return attempt(stretch, mode.with_lagging_friction());
}

/// False where contacts are those of the step before.
bool Solid::find_contacts() {
  if (contacts_stand_ && scene_.analysis.skip_searches) {
    ++counts_.skipped_searches;
    return false;
  }
  const Stopwatch watch(profile_.search);
  ++counts_.searches;
  search_.update(start_, contacts_);
  return true;
}

/// Phases of a step of few blocks take no longer than looks at the clock: but for the first steps, one in 16 is timed
/// and counts for all.
double Solid::timed() const {
  constexpr std::size_t few_blocks = 16;
  constexpr long steps = 16;
  if (blocks_.size() > few_blocks || counts_.steps < steps) return 1;
  return counts_.steps % steps == 0 ? static_cast<double>(steps) : 0;
}

/// One step, or nothing at all: all but a step that is made leaves the state as it was.
Outcome Solid::attempt(const Stretch& stretch, const StepMode& mode) {
  const auto& [dt, end_s, water] = stretch;
  const Stopwatch::Sample sample(timed());
  if (scene_.analysis.kind == scene::AnalysisKind::quasi_static) {
    for (BlockState& state : states_) state.velocity.setZero(), state.acceleration.setZero();
  }
  end_s_ = end_s;
  const long touching = mode.smooth_only ? touching_contacts() : 0;
  const bool searched = find_contacts();
  if (mode.smooth_only && touching_contacts() != touching)
    return Outcome::contacts_change;  // the search has dropped one
  const long state_changes_before = formulation_->state_changes();
  if (searched || islands_.empty()) prepare_islands();
  find_sliding_blocks();
  prepare_matrices(dt, mode.scheme);
  loads_.evaluate(end_s, water, start_, external_);
  if (guard_.acts()) guard(dt);
  require_finite_loads(end_s);
  for_each(blocks_.size(), [&](std::size_t b) {
    const bool own = !blocks_[b].is_part() && b >= guard_.blocks();
    history_[b] =
        own ? newmark_.history(blocks_[b].inertia, states_[b], dt) : newmark_.history(inertia(b), states_[b], dt);
    past_velocity_[b] = rate(b, start_[b], newmark_.past_velocity(states_[b], dt));
    predict(b);
  });
  predict_nodes(dt);
  carry_fixed_blocks(end_s);
  for (Support& support : supports_) {
    const auto b = static_cast<std::size_t>(support.block);
    support.separation = start_[b].displacement(support.material) - support.target(end_s) - base_.displacement(end_s);
  }

  bool solved = true;
  formulation_->settings().lasting_overlap_m =
      !mode.in_motion()
          ? 0
          : std::max(scene_.contact.penetration_tolerance_m, std::min(1e-8 * size_, lasting_overlap * fall_m()));
  for (const IslandSystem& s : islands_) {  // those asleep, too: a softened step lowers the penalties of all alike
    const Held held = held_by(s);
    formulation_->begin(at_start(), matrix_, frozen_, held);
    if (s.unknowns->total > large_island) formulation_->keep_forces(at_start(), held);
  }
  const bool sweeps = may_sweep(mode);
  const bool newton = !sweeps || !whole_law_.skips();
  bool found_all = true;  // by Newton's method, in the end
  for (IslandSystem& island : islands_) {
    island.asleep = may_sleep(island, mode);
    island.swept = false;
    if (island.asleep) {
      put_to_sleep(island);
    } else {
      const Stopwatch watch(profile_.equilibria);
      ++counts_.solved_islands;
      start_where_it_rests(island);
      const bool found =
          solved && newton &&
          (find_equilibrium(island, mode) || (mode.pivots && find_equilibrium_by_pivoting(island, mode)));
      solved = solved && (found || (sweeps && find_equilibrium_by_sweeps(island, mode)));
      found_all = found_all && !island.swept;
    }
  }
  if (sweeps && (newton || found_all)) found_all ? whole_law_.succeeded() : whole_law_.failed();
  const double moved = largest_increment();
  const Outcome outcome = !solved                                 ? Outcome::not_found
                          : goes_too_far(moved)                   ? Outcome::too_far
                          : mode.smooth_only && contacts_change() ? Outcome::contacts_change
                                                                  : Outcome::made;
  const bool made = outcome == Outcome::made;
  const bool seen = !made || (search_.covers(moved) && (moved == 0 || !search_.entered(placement_, contacts_)));
  if (!made || !seen) {
    for (const IslandSystem& s : islands_) formulation_->undo(held_by(s));
    contacts_stand_ = seen;
    return seen ? outcome : attempt(stretch, mode);
  }
  const bool otherwise = accept(stretch, mode);
  contacts_stand_ = moved == 0 && formulation_->state_changes() == state_changes_before && !otherwise;
  require_finite(end_s);
  return Outcome::made;
}

/// Do blocks move or turn by more than a step may?
bool Solid::goes_too_far(double moved_m) const {
  return !(moved_m <= scene_.analysis.max_displacement_ratio * size_ &&
           (moved_m == 0 || largest_turn() <= ContactSearch::most_turn));
}

/// What a step begins with: the block goes on as it moves.
void Solid::predict(std::size_t b) {
  increment_[b] = frozen_[b] ? Vector6::Zero() : Vector6(matrices_dt_ * states_[b].velocity);
  placement_[b] = Placement(blocks_[b].centroid, states_[b].displacement + increment_[b]);
}

/// Fixed blocks have no unknowns: the step finds them where a moving base takes them.
void Solid::carry_fixed_blocks(double end_s) {
  if (!base_.moves_supports()) return;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!blocks_[b].fixed) continue;
    increment_[b].head<2>() = base_.displacement(end_s) - states_[b].displacement.head<2>();
    placement_[b] = Placement(blocks_[b].centroid, states_[b].displacement + increment_[b]);
  }
}

/// Does any contact slip, or any block lie otherwise than the step had it?
bool Solid::accept(const Stretch& stretch, const StepMode& mode) {
  const double dt = stretch.dt;
  const double end_s = stretch.end_s;
  const Stopwatch watch(profile_.accept);
  time_s_ = end_s;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].fixed) states_[b].velocity.head<2>() = base_.velocity(end_s);
  }
  if (base_.moves_supports() && !mode.settles) {
    const Point moved = base_.displacement(end_s) - base_.displacement(end_s - dt);
    energy_balance_.lead(push_of_base(), moved, !newmark_.second_order());
  }
  bool any_slips = false;
  for (IslandSystem& island : islands_) {
    if (island.asleep) continue;
    for_each(island.island.blocks.size(), [&](std::size_t k) {
      const auto b = static_cast<std::size_t>(island.island.blocks[k]);
      began_with_[b] = states_[b].velocity;
      newmark_.finish(states_[b], blocks_[b].is_part() ? corner_increment(b) : increment_[b], dt);
      if (!newmark_.second_order() && !blocks_[b].is_part()) act_by_end_rates(b, dt);
      states_[b].force = at_corners(b, balance_[b]);
    });
    if (!mode.settles) balance_energy(island, dt);
    if (formulation_->holds_exactly()) {
      island.swept ? settle_swept_velocities(island, dt) : settle_held_velocities(island, dt);
    }
    take_back_energy(island, mode);
    if (guard_.acts()) energy_balance_.give(-taken_by_water(island));
    any_slips = formulation_->accept(trial(), held_by(island)) || any_slips;
  }
  if (scene_.analysis.integrator != scene::Integrator::shi) energy_balance_.end_step(external_);
  for (Bolt& bolt : bolts_) solid::accept(trial(), base_.displacement(end_s), bolt);
  for_each(blocks_.size(), [&](std::size_t b) {
    if (frozen_[b] && !base_.moves_supports()) return;
    states_[b].displacement += increment_[b];
    start_[b] = placement_[b];
  });
  follow_triangles();
  bool pushed = false;
  if (!mode.settles) {
    for (IslandSystem& island : islands_) {
      if (!island.asleep) pushed = push_apart(island) || pushed;
    }
  }
  sleep_.look(blocks_, increment_, external_, dt);
  ++counts_.steps;
  return any_slips || pushed;
}

bool Solid::may_sleep(const IslandSystem& s, const StepMode& mode) const {
  if (!scene_.analysis.sleep || mode.settles) return false;
  const double tolerance_n = formulation_->settings().force_tolerance_n;
  const auto rests = [&](int b) { return sleep_.rests(static_cast<std::size_t>(b), blocks_, external_, tolerance_n); };
  const auto in_place = [&](int k) {
    const Support& support = supports_[static_cast<std::size_t>(k)];
    return support.held().cwiseProduct(support.separation).norm() <= formulation_->settings().penetration_tolerance_m;
  };
  const auto rests_on = [&](int k) {
    const ContactPoint& c = contacts_[static_cast<std::size_t>(k)];
    return rests(c.vertex_part) && rests(c.edge_part);
  };
  const auto hangs_still = [&](int k) {
    const auto& ends = bolts_[static_cast<std::size_t>(k)].part;
    return std::all_of(ends.begin(), ends.end(), [&](int b) { return b < 0 ? !base_.moves_supports() : rests(b); });
  };
  return std::all_of(s.island.blocks.begin(), s.island.blocks.end(), rests) &&
         std::all_of(s.bolts.begin(), s.bolts.end(), hangs_still) &&
         std::all_of(s.island.supports.begin(), s.island.supports.end(), in_place) &&
         std::all_of(s.island.contacts.begin(), s.island.contacts.end(), rests_on);
}

void Solid::put_to_sleep(const IslandSystem& s) {
  ++counts_.slept_islands;
  for (const int block : s.island.blocks) {
    const auto b = static_cast<std::size_t>(block);
    increment_[b].setZero();
    placement_[b] = start_[b];
    states_[b].velocity.setZero();
    states_[b].acceleration.setZero();
  }
}

/// Largest turn of any block near others in the step at hand [rad].
double Solid::largest_turn() const {
  const auto turn = [this](int b) { return std::abs(increment_[static_cast<std::size_t>(b)][2]); };
  return largest(contacts_.size(),
                 [&](std::size_t k) { return std::max(turn(contacts_[k].vertex_part), turn(contacts_[k].edge_part)); });
}

/// Largest displacement of any vertex in the step at hand [m].
double Solid::largest_increment() const {
  return largest(blocks_.size(), [&](std::size_t b) {
    double moved = 0;
    if ((frozen_[b] && !base_.moves_supports()) || increment_[b].isZero(0)) return moved;
    for (const Point& X : blocks_[b].vertices) moved = std::max(moved, start_[b].increment(increment_[b], X).norm());
    return moved;
  });
}

}  // namespace blockweir::solid
