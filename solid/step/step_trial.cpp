// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/step_trial.hpp"

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "solid/block/corners.hpp"
#include "solid/block/parallel.hpp"

namespace blockweir::solid {

StepTrial::StepTrial(const Model& model, const State& state)
    : scheme(model.scheme), placement(state.placements), model_(model), state_(state) {
  const std::size_t n = model.blocks.size();
  for (const Block& block : model.blocks) frozen.push_back(block.fixed || block.meshed);
  node_increment.resize(static_cast<std::size_t>(model.parts.nodes));
  matrix.resize(n);
  external.resize(n);
  history.resize(n);
  past_velocity.assign(n, Vector6::Zero());
  began_with.assign(n, Vector6::Zero());
  for_motion.assign(n, 0);
  increment.assign(n, Vector6::Zero());
  turn.resize(n);
  still_ = increment;
  unturned_ = turn;
  balance.assign(n, Vector6::Zero());
  round_off.resize(n);
}

/// Of a block with a mesh all triangles. Matrices are made anew where another block slides.
void StepTrial::find_sliding_blocks() {
  if (state_.contacts_stand && !slides_.empty()) return;
  std::vector<bool> slides(model_.blocks.size());
  for (const ContactPoint& c : state_.contacts) {
    if (c.state != ContactState::slip) continue;
    for (const int block : {c.vertex_block, c.edge_block}) {
      slides[at(block)] = true;
      for (const int t : model_.parts.triangles[at(block)]) slides[at(t)] = true;
    }
  }
  if (slides == slides_) return;
  slides_.swap(slides);
  dt = -1;
}

void StepTrial::set_matrices(double step_s, const Newmark& of_scheme) {
  if (dt == step_s && scheme == of_scheme) return;
  dt = step_s;
  scheme = of_scheme;
  for_each(model_.blocks.size(), [&](std::size_t b) {
    const double velocity_factor = scheme.velocity_factor(dt);
    const double drag = velocity_factor * model_.scene.analysis.mass_damping_per_s;
    matrix[b] = (scheme.mass_factor(dt) + drag) * model_.blocks[b].inertia.matrix();
    matrix[b].bottomRightCorner<3, 3>() += (1 + velocity_factor * retardation_s(b)) * model_.blocks[b].stiffness;
    if (b < state_.guard.blocks()) matrix[b].topLeftCorner<3, 3>() += scheme.mass_factor(dt) * state_.guard.mass(b);
    if (model_.boundary.empty()) return;
    matrix[b] += scheme.damps ? Matrix6(velocity_factor * model_.boundary.drag(b)) : model_.boundary.hold(b);
  });
}

void StepTrial::begin() {
  fastest_m_per_s_ = state_.fastest_m_per_s();
  for_each(model_.blocks.size(), [&](std::size_t b) {
    const bool own = !model_.blocks[b].is_part() && b >= state_.guard.blocks();
    history[b] = own ? scheme.history(model_.blocks[b].inertia, state_.blocks[b], dt)
                     : scheme.history(inertia(b), state_.blocks[b], dt);
    past_velocity[b] = rate(b, state_.placements[b], scheme.past_velocity(state_.blocks[b], dt));
    predict(b);
  });
  predict_nodes();
  carry_fixed_blocks();
}

void StepTrial::predict(std::size_t b) {
  go_to(b, frozen[b] ? Vector6::Zero() : Vector6(dt * state_.blocks[b].velocity));
}

void StepTrial::go_to(std::size_t b, const Vector6& moved) {
  increment[b] = moved;
  turn[b] = Turn(moved[2]);
  placement[b] = Placement(model_.blocks[b].centroid, state_.blocks[b].displacement + moved);
}

/// Nodes go on at their velocity.
void StepTrial::predict_nodes() {
  for (std::size_t t = model_.described(); t < model_.blocks.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      node_increment[at(model_.blocks[t].nodes[at(i)])] =
          (frozen[t] ? 0 : dt) * state_.blocks[t].velocity.segment<2>(2 * i);
    }
  }
  for (std::size_t t = model_.described(); t < model_.blocks.size(); ++t) follow_corners(t);
}

void StepTrial::follow_corners(std::size_t t) {
  go_to(t, increment_of(model_.blocks[t], state_.placements[t], corner_increment(t)));
}

Vector6 StepTrial::corner_increment(std::size_t t) const {
  Vector6 moved;
  for (int i = 0; i < 3; ++i) moved.segment<2>(2 * i) = node_increment[at(model_.blocks[t].nodes[at(i)])];
  return moved;
}

/// Fixed blocks have no unknowns: the step finds them where a moving base takes them.
void StepTrial::carry_fixed_blocks() {
  if (!model_.base.moves_supports()) return;
  for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
    if (!model_.blocks[b].fixed) continue;
    increment[b].head<2>() = model_.base.displacement(end_s) - state_.blocks[b].displacement.head<2>();
    placement[b] = Placement(model_.blocks[b].centroid, state_.blocks[b].displacement + increment[b]);
  }
}

Vector6 StepTrial::rate(std::size_t b, const Placement& at_placement, const Vector6& of_state) const {
  if (!model_.blocks[b].is_part() || of_state.isZero(0)) return of_state;
  return corner_map(model_.blocks[b], at_placement) * of_state;
}

Vector6 StepTrial::at_corners(std::size_t b, const Vector6& force) const {
  if (!model_.blocks[b].is_part()) return force;
  return corner_map(model_.blocks[b], placement[b]).transpose() * force;
}

Matrix6 StepTrial::inertia(std::size_t b) const {
  Matrix6 mass = model_.blocks[b].is_part() ? corner_mass(model_.blocks[b]) : model_.blocks[b].inertia.matrix();
  if (b < state_.guard.blocks()) mass.topLeftCorner<3, 3>() += state_.guard.mass(b);
  return mass;
}

bool StepTrial::goes_too_far() const {
  return !(moved_m <= model_.scene.analysis.max_displacement_ratio * model_.size_m &&
           (moved_m == 0 || largest_turn() <= ContactSearch::most_turn));
}

/// Largest turn of any block near others in the step at hand [rad]. Loads may turn one that has no contact yet.
double StepTrial::largest_turn() const {
  const auto turned = [this](int part) { return std::abs(increment[at(part)][2]); };
  const auto of_block = [&](int b) { return model_.parts.triangles[at(b)].empty() ? turned(b) : 0; };
  const auto& near = state_.search.near_pairs();
  const double of_blocks =
      largest(near.size(), [&](std::size_t k) { return std::max(of_block(near[k].first), of_block(near[k].second)); });
  return std::max(of_blocks, largest(state_.contacts.size(), [&](std::size_t k) {
                    return std::max(turned(state_.contacts[k].vertex_part), turned(state_.contacts[k].edge_part));
                  }));
}

double StepTrial::largest_increment() const {
  return largest(model_.blocks.size(), [&](std::size_t b) {
    double moved = 0;
    if ((frozen[b] && !model_.base.moves_supports()) || increment[b].isZero(0)) return moved;
    for (const Point& X : model_.blocks[b].vertices)
      moved = std::max(moved, state_.placements[b].increment(increment[b], turn[b], X).norm());
    return moved;
  });
}

}  // namespace blockweir::solid
