// SPDX-License-Identifier: GPL-3.0-or-later
// The residual: what acts at the trial, less inertia.
#include "solid/step/island_equations.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/corners.hpp"
#include "solid/block/parallel.hpp"

namespace blockweir::solid {
namespace {

/// A generalized force as a plain one: moments and strain forces over the block's radius [N per metre].
double magnitude(const Vector6& force, const Block& block) {
  const double turning = block.rigid ? std::abs(force[2]) : force.tail<4>().cwiseAbs().maxCoeff();
  return std::max(force.head<2>().cwiseAbs().maxCoeff(), turning / block.radius);
}

/// Largest unbalanced force there, less what round-off explains.
double unbalanced_at_nodes(const IslandEquations& s) {
  double left = 0;
  for (const auto& [node, first] : s.unknowns->nodes) {
    for (const int i : {first, first + 1}) {
      const double force = std::abs(s.residual[i]);
      left = std::isfinite(force) ? std::max(left, force - s.uncertain[i]) : force;
      if (!std::isfinite(left)) return left;
    }
  }
  return left;
}

}  // namespace

IslandEquations::IslandEquations(StepWorkspace& step, const WaterInertia& water, const std::vector<int>& numbers,
                                 Island given_island, std::unique_ptr<Unknowns> given_unknowns)
    : StepPart(step),
      island(std::move(given_island)),
      unknowns(std::move(given_unknowns)),
      residual(unknowns->total),
      correction(unknowns->total),
      water_(water),
      numbers_(numbers),
      forces_(step, *unknowns) {}

LinearSystem& IslandEquations::system() const {
  if (!system_) system_ = make_linear_system(*unknowns, island.couples);
  return *system_;
}

double IslandEquations::unbalanced() {
  const Stopwatch watch(profile_.assembly);
  balance_alone();
  evaluate_interactions();
  return find_residual([&](std::size_t k) { add_forces(k); });
}

void IslandEquations::balance_alone() {
  if (unknowns->shared()) set_corner_maps();
  for_each(island.blocks.size(), [&](std::size_t k) { balance_own(at(island.blocks[k])); });
  balance_couplings();
}

double IslandEquations::find_residual(const std::function<void(std::size_t)>& also_acts) {
  residual.setZero();
  uncertain.setZero(unknowns->shared() ? residual.size() : 0);
  water_.add_to_residual(*this);
  const double at_blocks = largest(island.blocks.size(), [&](std::size_t k) {
    if (also_acts) also_acts(k);
    return model_.blocks[at(island.blocks[k])].is_part() ? 0.0 : add_residual(k);
  });
  if (!std::isfinite(at_blocks) || !unknowns->shared()) return at_blocks;
  for (std::size_t k = 0; k < island.blocks.size(); ++k) {
    if (model_.blocks[at(island.blocks[k])].is_part()) add_residual_at_corners(static_cast<int>(k));
  }
  return std::max(at_blocks, unbalanced_at_nodes(*this));
}

/// Loads, elasticity and drag of a block.
void IslandEquations::balance_own(std::size_t b) {
  const Block& block = model_.blocks[b];
  const Vector6 velocity = trial_.scheme.velocity_factor(trial_.dt) * trial_.increment[b] + trial_.past_velocity[b];
  Vector6 drag = model_.scene.analysis.mass_damping_per_s * (block.inertia * velocity);
  drag.tail<3>() += trial_.retardation_s(b) * (block.stiffness * velocity.tail<3>());
  if (!model_.boundary.empty()) {
    drag += trial_.scheme.damps
                ? Vector6(model_.boundary.drag(b) * velocity)
                : Vector6(model_.boundary.hold(b) * (state_.blocks[b].displacement + trial_.increment[b]));
  }
  trial_.balance[b] = trial_.external[b] - drag;
  trial_.balance[b].tail<3>() -= block.stiffness * (state_.blocks[b].displacement + trial_.increment[b]).tail<3>();
  trial_.round_off[b] = sum_round_off * (magnitude(trial_.external[b], block) + magnitude(drag, block));
}

void IslandEquations::balance_couplings() {
  const auto retarded = [this](std::size_t t) -> Eigen::Vector3d {
    const Vector6 velocity = trial_.scheme.velocity_factor(trial_.dt) * trial_.increment[t] + trial_.past_velocity[t];
    return (state_.blocks[t].displacement + trial_.increment[t] + trial_.retardation_s(t) * velocity).tail<3>();
  };
  for (const int k : couplings) {
    const StrainCoupling& c = model_.parts.couplings[at(k)];
    trial_.balance[at(c.i)].tail<3>() -= c.stiffness * retarded(at(c.j));
    trial_.balance[at(c.j)].tail<3>() -= c.stiffness * retarded(at(c.i));
  }
}

/// What contacts, supports and bolts of an island do at the trial.
void IslandEquations::evaluate_interactions() {
  const Stopwatch watch(profile_.contact);
  std::atomic<bool> symmetric = true;
  const auto keep = [&](std::size_t k, const Interaction& action) {
    actions[k] = action;
    if (action.stiffness(1, 0) != action.stiffness(0, 1)) symmetric.store(false, std::memory_order_relaxed);
  };
  const Trial now = trial_.now();
  const std::vector<int>& contacts = island.contacts;
  const std::vector<int>& supports = island.supports;
  const std::size_t of_bolts = contacts.size() + supports.size();
  actions.resize(of_bolts + bolts.size());
  for_each(contacts.size(),
           [&](std::size_t i) { keep(i, formulation_->contact(now, contacts[i], state_.contacts[at(contacts[i])])); });
  for (std::size_t i = 0; i < supports.size(); ++i) {
    keep(contacts.size() + i, formulation_->support(now, supports[i], state_.supports[at(supports[i])]));
  }
  for (std::size_t i = 0; i < bolts.size(); ++i) {
    keep(of_bolts + i, interaction_of(now, state_.bolts[at(bolts[i])], model_.base.displacement(trial_.end_s)));
  }
  symmetric_ = symmetric;
  forces_.set(*this, water_);
}

void IslandEquations::add_forces(std::size_t k) {
  const auto b = at(island.blocks[k]);
  for (const Incidence::End& end : incidence.of(k)) {
    const Interaction& action = actions[at(end.interaction)];
    if (action.force.isZero(0)) continue;
    const Vector6 force = trial_.placement[b].generalized((end.second ? -1 : 1) * action.pull(), action.at(end.second));
    trial_.balance[b] += force;
    trial_.round_off[b] += sum_round_off * magnitude(force, model_.blocks[b]) + action.round_off;
  }
}

/// Of an island's block k: balance less inertia. Returns the unbalanced force, less what round-off explains.
double IslandEquations::add_residual(std::size_t k) {
  const double mass_factor = trial_.scheme.mass_factor(trial_.dt);
  const auto b = at(island.blocks[k]);
  Vector6 inertia = mass_factor * (model_.blocks[b].inertia * trial_.increment[b]);
  if (b < state_.guard.blocks())
    inertia.head<3>() += mass_factor * (state_.guard.mass(b) * trial_.increment[b].head<3>());
  if (!pulls.empty()) inertia -= pulls[k];
  const Vector6 left = trial_.balance[b] - inertia + trial_.history[b];
  unknowns->add(static_cast<int>(k), left, residual);
  const double noise = trial_.round_off[b] + sum_round_off * (magnitude(inertia, model_.blocks[b]) +
                                                              magnitude(trial_.history[b], model_.blocks[b]));
  const double force = magnitude(left, model_.blocks[b]);
  return std::isfinite(force) ? std::max(0.0, force - noise) : force;
}

/// Balance less inertia, to the triangle's corners; so is what round-off leaves uncertain.
void IslandEquations::add_residual_at_corners(int k) {
  constexpr double corner_share = 4;  // of a block's force that may fall to one corner, slender triangles included
  const auto t = at(island.blocks[at(k)]);
  const Vector6 pull =
      trial_.scheme.mass_factor(trial_.dt) * (corner_mass(model_.blocks[t]) * trial_.corner_increment(t));
  unknowns->add(k, trial_.balance[t], residual);
  const Vector6 left = trial_.history[t] - pull;
  const double noise =
      trial_.round_off[t] + sum_round_off * (pull.cwiseAbs().maxCoeff() + trial_.history[t].cwiseAbs().maxCoeff());
  const auto numbers = unknowns->of(k);
  for (Eigen::Index i = 0; i < 6; ++i) {
    residual[numbers[at(static_cast<int>(i))]] += left[i];
    uncertain[numbers[at(static_cast<int>(i))]] += corner_share * noise;
  }
}

void IslandEquations::set_corner_maps() {
  for (int k = 0; k < unknowns->blocks(); ++k) {
    const auto b = at(island.blocks[at(k)]);
    if (model_.blocks[b].is_part()) unknowns->set_map(k, corner_map(model_.blocks[b], trial_.placement[b]));
  }
}

}  // namespace blockweir::solid
