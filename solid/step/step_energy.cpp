// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/step_energy.hpp"

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

void StepEnergy::balance(IslandEquations& s, double dt) {
  const bool by_shi = !trial_.scheme.second_order();
  const auto strained = [this](int b) { return trial_.increment[at(b)].tail<3>(); };
  const auto strain = [this](int b) { return state_.blocks[at(b)].displacement.tail<3>(); };
  for (const int block : s.island.blocks) {
    const auto b = at(block);
    const Vector6 load = state_.energy.through_step(b, trial_.external[b], by_shi);
    const double work = model_.blocks[b].is_part() ? trial_.at_corners(b, load).dot(trial_.corner_increment(b))
                                                   : load.dot(trial_.increment[b]);
    state_.energy.give(work - model_.loads.constant(b).dot(trial_.increment[b]));
    const double led = pushes_.empty() ? 0 : push_of_base(b, load, dt).dot(moved_);
    state_.energy.give(led);
    trial_.for_motion[b] =
        work + led - strained(block).dot(model_.blocks[b].stiffness * (strain(block) + strained(block) / 2));
  }
  for (const int k : s.couplings) {
    const StrainCoupling& c = model_.parts.couplings[at(k)];
    trial_.for_motion[at(c.i)] -= strained(c.i).dot(c.stiffness * (strain(c.j) + strained(c.j) / 2)) +
                                  (strain(c.i) + strained(c.i) / 2).dot(c.stiffness * strained(c.j));
  }
  for (const int k : s.island.supports) give_by_support(k, dt);
  const auto keep = [&](const Interaction& action, double rise) {
    trial_.for_motion[at(trial_.moves(action.block_i) ? action.block_i : action.block_j)] -= rise;
  };
  const auto store = [&](const Interaction& action, double rise) {
    state_.energy.store(rise);
    keep(action, rise);
  };
  const auto stored_by_support = [this](int k) {
    const Support& support = state_.supports[at(k)];
    if (formulation_->holds_exactly()) return 0.0;
    const double begins = support.held().cwiseProduct(support.separation).squaredNorm();
    return support.penalty * (formulation_->progress().support(k).separation.squaredNorm() - begins) / 2;
  };
  std::size_t next = 0;
  for (const int k : s.island.contacts) {
    keep(s.actions[next++], state_.contacts[at(k)].stored_j_per_m - formulation_->before().contact(k).stored_j_per_m);
  }
  for (const int k : s.island.supports) store(s.actions[next++], stored_by_support(k));
  for (const int k : s.bolts) {
    const Bolt& bolt = state_.bolts[at(k)];
    const double tension = -s.actions[next].force.x();
    const double before = bolt.acting.tension_n_per_m;
    store(s.actions[next++], (tension - before) * (tension + before) / (2 * bolt.described->stiffness_n_per_m2));
  }
}

/// Steps without velocities have lengths of their own: the way is that from where the last step has left the target.
/// Besides it, the work counts what the point moves by the mean of its velocities beyond its displacement. Only
/// generalized-alpha has such a difference, and much of it where the target starts or stops with a leap of its
/// velocity.
void StepEnergy::give_by_support(int k, double dt) const {
  Support& support = state_.supports[at(k)];
  const Support& before = formulation_->before().support(k);
  support.inertial = trial_.scheme.inertial(before.force, support.force, before.inertial);
  const Point force = trial_.scheme.through_step(before.inertial, support.inertial);
  const auto b = at(support.block);
  const Placement& placement = trial_.placement[b];
  const Vector6 increment = model_.blocks[b].is_part() ? trial_.corner_increment(b) : trial_.increment[b];
  const Vector6 beyond = dt / 2 * (trial_.began_with[b] + state_.blocks[b].velocity) - increment;
  give(b, force.dot(support.target(trial_.end_s) - support.stood) +
              placement.generalized(force, support.material).dot(trial_.rate(b, placement, beyond)));
}

void StepEnergy::lead(const StepIslands& islands, const Point& moved) {
  moved_ = moved;
  pushes_.assign(model_.blocks.size(), Point::Zero());
  on_base_.assign(model_.blocks.size(), false);
  for (const IslandEquations& s : islands) {
    if (s.found == Found::asleep) continue;
    bool on_base = false;
    for (const Interaction& action : s.actions) {
      for (const bool second : {false, true}) {
        if (trial_.moves(action.block(second))) continue;
        pushes_[at(action.block(!second))] += (second ? 1 : -1) * action.pull();
        on_base = true;
      }
    }
    for (const int b : s.island.blocks) on_base_[at(b)] = on_base;
  }
}

/// Over a step. Generalized-alpha weights forces in its own way: there it is the momentum gained beyond loads and
/// damping; forces between blocks of a group do not matter, since the base moves all alike.
Point StepEnergy::push_of_base(std::size_t b, const Vector6& load, double dt) const {
  if (!on_base_[b]) return Point::Zero();  // as on viscous ground, whose free field is a load
  if (!trial_.scheme.second_order()) return pushes_[b];
  if (trial_.scheme.alpha_f == 0) return state_.energy.push_through_step(b, pushes_[b]);
  const bool part = model_.blocks[b].is_part();
  const Vector6 moved = part ? trial_.corner_increment(b) : trial_.increment[b];
  const Vector6 gained = state_.blocks[b].velocity - trial_.began_with[b];
  const Vector6 force = trial_.inertia(b) * (gained + model_.scene.analysis.mass_damping_per_s * moved) / dt;
  return (part ? Point(force.head<2>() + force.segment<2>(2) + force.tail<2>()) : Point(force.head<2>())) -
         load.head<2>();
}

/// Rates of a block that goes with the base, or with supports, at that velocity.
Vector6 StepEnergy::going_at(std::size_t b, const Point& velocity) const {
  Vector6 rates = Vector6::Zero();
  rates.head<2>() = velocity;
  if (model_.blocks[b].is_part()) rates.segment<2>(2) = rates.tail<2>() = velocity;
  return rates;
}

double StepEnergy::give_by_carrier(std::size_t b, const Point& velocity, const Vector6& before) const {
  const double work = going_at(b, velocity).dot(trial_.inertia(b) * (state_.blocks[b].velocity - before));
  give(b, work);
  return work;
}

void StepEnergy::give(std::size_t b, double work) const {
  state_.energy.give(work);
  trial_.for_motion[b] += work;
}

}  // namespace blockweir::solid
