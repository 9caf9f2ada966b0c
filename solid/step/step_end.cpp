// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/step_end.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/step/angular_momentum.hpp"
#include "solid/step/constrained_velocities.hpp"
#include "solid/step/mesh_motion.hpp"
#include "solid/step/push_apart.hpp"
#include "solid/step/step_energy.hpp"

namespace blockweir::solid {
namespace {

/// Of a block, with the water that it pushes [J per metre].
double kinetic_energy(const StepWorkspace& step, std::size_t b, const Vector6& velocity) {
  return velocity.dot(step.trial.inertia(b) * velocity) / 2;
}

bool supports_lead(const StepWorkspace& step, const IslandEquations& s) {
  return std::any_of(s.island.supports.begin(), s.island.supports.end(), [&](int k) {
    const Support& support = step.state.supports[at(k)];
    return support.target(step.trial.end_s) != support.target(step.trial.end_s - step.trial.dt);
  });
}

/// Velocities become those of the constraints. The impulses that carry blocks along supply energy: from a base with its
/// velocity, and from supports, each with its own, all else that the blocks gain.
void settle_velocities(StepWorkspace& step, IslandEquations& s, double dt, bool base_leads, bool starts) {
  const bool led = !starts && supports_lead(step, s);
  if (!base_leads && !led) return ConstrainedVelocities(step).settle(s, dt);
  std::vector<Vector6> before;
  for (const int block : s.island.blocks) before.push_back(step.state.blocks[at(block)].velocity);
  ConstrainedVelocities(step).settle(s, dt);
  const StepEnergy energy(step);
  const Point base = step.model.base.velocity(step.trial.end_s);
  for (std::size_t k = 0; k < before.size(); ++k) {
    const auto b = at(s.island.blocks[k]);
    const double by_base = base_leads ? energy.give_by_carrier(b, base, before[k]) : 0;
    if (!led) continue;
    const Vector6& now = step.state.blocks[b].velocity;
    energy.give(b, kinetic_energy(step, b, now) - kinetic_energy(step, b, before[k]) - by_base);
  }
}

}  // namespace

bool StepEnd::accept(const Stretch& stretch, const StepMode& mode) {
  const double dt = stretch.dt;
  const double end_s = stretch.end_s;
  const Stopwatch watch(profile_.accept);
  state_.time_s = end_s;
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    if (model_.blocks[b].fixed) state_.blocks[b].velocity.head<2>() = model_.base.velocity(end_s);
  }
  const bool led = model_.base.moves_supports() && !mode.settles;
  StepEnergy energy(step_);
  if (led) energy.lead(islands_, model_.base.displacement(end_s) - model_.base.displacement(end_s - dt));
  bool any_slips = false;
  for (IslandEquations& island : islands_) {
    if (island.found == Found::asleep) continue;
    if (island.found == Found::by_sweeps) counts_.residual_m = std::max(counts_.residual_m, island.left_m);
    accept_motion(island, dt);
    if (!mode.settles) {
      energy.balance(island, dt);
      water_.pass_on(island, dt);
    }
    if (formulation_->holds_exactly()) settle_velocities(step_, island, dt, led, mode.settles);
    if (!mode.settles) AngularMomentum(step_).restore(island);
    any_slips = formulation_->accept(trial_.now(), island.island_contacts()) || any_slips;
  }
  for (Support& support : state_.supports) support.stood = support.target(end_s);
  for (Bolt& bolt : state_.bolts) solid::accept(trial_.now(), model_.base.displacement(end_s), bolt);
  for_each(model_.blocks.size(), [&](std::size_t b) {
    if (trial_.frozen[b] && !model_.base.moves_supports()) return;
    state_.blocks[b].displacement += trial_.increment[b];
    state_.placements[b] = trial_.placement[b];
  });
  follow_triangles(model_, trial_, state_);
  bool pushed = false;
  if (!mode.settles) {
    for (IslandEquations& island : islands_) {
      if (island.found != Found::asleep) pushed = PushApart(step_).push(island) || pushed;
    }
  }
  for (IslandEquations& island : islands_) {
    if (island.found == Found::asleep) continue;
    if (!water_.of_meshes()) energy.take_back(island);
    if (state_.guard.acts()) state_.energy.give(-water_.taken_by_water(island));
  }
  if (led) state_.energy.end_step_pushed_by(energy.pushes());
  if (model_.scene.analysis.integrator != scene::Integrator::shi) state_.energy.end_step(trial_.external);
  state_.sleep.look(model_.blocks, trial_.increment, trial_.external, dt);
  ++counts_.steps;
  return any_slips || pushed;
}

bool StepEnd::affords_motion(double dt) {
  constexpr int soon = 10;  // steps
  if (state_.smooth_steps > soon || water_.of_meshes() || model_.base.moves_supports()) return true;
  const std::vector<BlockState> blocks = state_.blocks;
  const std::vector<Vector6> balance = trial_.balance;
  const EnergyBalance balanced = state_.energy;
  StepEnergy energy(step_);
  bool affords = true;
  for (IslandEquations& island : islands_) {
    if (island.found == Found::asleep) continue;
    accept_motion(island, dt);
    energy.balance(island, dt);
    water_.pass_on(island, dt);
    if (formulation_->holds_exactly()) settle_velocities(step_, island, dt, /*base_leads=*/false, /*starts=*/false);
    affords = affords && energy.affords(island);
  }
  state_.blocks = blocks;
  state_.energy = balanced;
  trial_.balance = balance;
  return affords;
}

void StepEnd::accept_motion(IslandEquations& island, double dt) {
  for_each(island.island.blocks.size(), [&](std::size_t k) {
    const auto b = static_cast<std::size_t>(island.island.blocks[k]);
    trial_.began_with[b] = state_.blocks[b].velocity;
    trial_.scheme.finish(state_.blocks[b],
                         model_.blocks[b].is_part() ? trial_.corner_increment(b) : trial_.increment[b], dt);
    if (!trial_.scheme.second_order() && !model_.blocks[b].is_part()) act_by_end_rates(b, dt);
    state_.blocks[b].force = trial_.at_corners(b, trial_.balance[b]);
  });
}

/// Viscous forces in a step of Shi's scheme use its mean rates. The trapezoidal rule continues from those of its end:
/// their mean over a step is that of the mean rate, and dissipates. Generalized-alpha weights them differently and
/// would produce energy.
void StepEnd::act_by_end_rates(std::size_t b, double dt) {
  if (model_.scene.analysis.integrator != scene::Integrator::trapezoidal || !trial_.scheme.damps) return;
  BlockState& state = state_.blocks[b];
  const Vector6 beyond = state.velocity - trial_.increment[b] / dt;
  const double drag = model_.scene.analysis.mass_damping_per_s;
  state.acceleration -= drag * beyond;
  trial_.balance[b] -= drag * (model_.blocks[b].inertia * beyond);
  if (!model_.boundary.empty()) {
    const Vector6 pull = model_.boundary.drag(b) * beyond;
    trial_.balance[b] -= pull;
    const Eigen::Index moves = model_.blocks[b].unknowns();
    const Matrix6 inertia = model_.blocks[b].inertia.matrix();
    state.acceleration.head(moves) -= inertia.topLeftCorner(moves, moves).ldlt().solve(pull.head(moves));
  }
  // Strains that push water accelerate other motions with them: theirs alone may not change.
  const bool push_water = state_.guard.motions() > state_.guard.blocks();
  if (model_.blocks[b].rigid || trial_.retardation_s(b) == 0 || push_water) return;
  const Eigen::Vector3d strain = trial_.retardation_s(b) * (model_.blocks[b].stiffness * beyond.tail<3>());
  trial_.balance[b].tail<3>() -= strain;
  const Eigen::Matrix4d inertia = model_.blocks[b].inertia.matrix().bottomRightCorner<4, 4>();
  state.acceleration.tail<4>() -= inertia.ldlt().solve(Eigen::Vector4d(0, strain[0], strain[1], strain[2]));
}

}  // namespace blockweir::solid
