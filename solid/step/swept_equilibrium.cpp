// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of an island whose contact states Newton's method does not find: sweeps over its contacts. Their number
// is bounded; wherever they stop, forces are admissible and momentum balances.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/step/solid.hpp"
#include "solid/step/temporarily.hpp"

namespace blockweir::solid {
namespace {

constexpr int rounds = 2;             // blocks turn: forces act along other directions where that has taken them
constexpr double most_visits = 3e4;   // to contacts, in the first round
constexpr double least_sweeps = 100;  // where an island is large
constexpr double most_sweeps = 1000;  // also of the first step that is swept: what follows begins with its forces

}  // namespace

bool Solid::find_equilibrium_by_sweeps(IslandSystem& s, const StepMode& mode) {
  ++counts_.swept_islands;
  s.swept = true;
  const Held held = held_by(s);
  formulation_->undo(held);
  start_again(s);
  {
    const Temporarily swept(formulation_->settings().swept, true);
    formulation_->begin(at_start(), matrix_, frozen_, held);
  }
  const bool begins = !whole_law_.after_failure();
  const double closely = begins || s.unknowns->total <= few_unknowns ? 1e-4 : 1;
  const double enough_m = closely * std::min(2e-8 * size_, 1e-4 * fall_m());
  constexpr int most_rounds = 20;  // bonds break a few at a time
  double left_m = 0;
  for (int round = 1;; ++round) {
    if (!linearize(s)) return false;
    const double visits = most_visits / static_cast<double>(s.sweeps.rows().size());
    const double most = !begins ? std::clamp(visits, least_sweeps, most_sweeps) : most_sweeps;
    left_m = sweep(s, static_cast<int>(round == 1 ? most : most / 4), enough_m);
    s.correction = s.sweeps.displacement();
    if (!s.correction.allFinite()) return false;
    move(s, 1);
    take_forces(s);
    const bool broken =
        break_bonds(laws_, formulation_->settings().force_tolerance_n, blocks_, s.island.contacts, contacts_);
    if (round >= rounds && (!broken || round >= most_rounds)) break;
  }
  // From states and forces that are next to right Newton's method is exact in a solution or two.
  const bool near = left_m <= enough_m && formulation_->holds_exactly();
  const bool small = s.unknowns->total <= few_unknowns;
  if (near && (small || !finish_.skips())) {
    s.swept = !or_undone(s, [&] { return finish_swept(s, mode); });
    if (!small) s.swept ? finish_.failed() : finish_.succeeded();
    if (!s.swept) return true;
  }
  counts_.residual_m = std::max(counts_.residual_m, left_m);
  take_forces(s);
  balance_alone(s);
  find_residual(s, [&](std::size_t k) { take_up(s, k); });
  return true;
}

/// Begins with the forces found, to the last digit, so that their states stand, and with softer penalties: these leave
/// sticking contacts a range of slips that Newton's method does not pass by.
bool Solid::finish_swept(IslandSystem& s, const StepMode& mode) {
  const double softer = s.unknowns->total <= few_unknowns ? 1 : 1e-3;
  for (const int k : s.island.contacts) contacts_[at(k)].penalty *= softer;
  for (const int k : s.island.supports) supports_[at(k)].penalty *= softer;
  formulation_->keep_forces(trial(), held_by(s));
  return find_equilibrium(s, mode);
}

/// What the last sweep still moved. Where steep friction makes forces go to and fro, they go half the way.
double Solid::sweep(IslandSystem& s, int most, double enough_m) {
  constexpr int look = 20;  // sweeps after which less should be left
  const Stopwatch watch(profile_.sweeps);
  double left_m = 0;
  double looked_m = std::numeric_limits<double>::infinity();
  double share = 1;
  for (int sweep = 1; sweep <= most; ++sweep) {
    ++counts_.sweeps;
    left_m = s.sweeps.sweep(share);
    if (left_m <= enough_m) break;
    if (sweep % look != 0) continue;
    share = left_m < looked_m ? 1 : 0.5;
    looked_m = left_m;
  }
  return left_m;
}

/// The trial goes on as blocks move.
void Solid::start_again(const IslandSystem& s) {
  for (const int block : s.island.blocks) {
    const auto b = at(block);
    if (!blocks_[b].is_part()) {
      predict(b);
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      node_increment_[at(blocks_[b].nodes[at(i)])] = matrices_dt_ * states_[b].velocity.segment<2>(2 * i);
    }
  }
  for (const int block : s.island.blocks) {
    if (blocks_[at(block)].is_part()) follow_corners(at(block));
  }
}

/// Gaps and slips about the trial, and what forces do to them.
bool Solid::linearize(IslandSystem& s) {
  const Stopwatch watch(profile_.assembly);
  balance_alone(s);
  find_residual(s, {});
  const bool shared = s.unknowns->shared();
  if (shared) {
    set_block_matrices(s);
    if (!solve(s, /*symmetric=*/true)) return false;
  } else {
    for_each(s.island.blocks.size(), [&](std::size_t k) {
      const auto first = s.unknowns->first[k];
      if (s.unknowns->count[k] == 3) {
        s.correction.segment<3>(first) =
            matrix_[at(s.island.blocks[k])].topLeftCorner<3, 3>().llt().solve(s.residual.segment<3>(first));
      } else {
        s.correction.segment<6>(first) = matrix_[at(s.island.blocks[k])].llt().solve(s.residual.segment<6>(first));
      }
    });
  }
  s.sweeps.begin(s.correction);
  const Trial now = trial();
  for (const int k : s.island.contacts) {
    const ContactPoint& c = contacts_[at(k)];
    const Ruled ruled = formulation_->ruled_contact(now, k, c);
    const EdgeFrame edge = edge_frame(now, c);
    add_row(s, ruled, interaction_of(c, edge, ruled.apart.y()), c.state == ContactState::open ? Point(0, 0) : c.force);
  }
  for (const int k : s.island.supports) {
    const Support& support = supports_[at(k)];
    add_row(s, formulation_->ruled_support(now, k, support), interaction_of(support), support.force);
  }
  for (const int k : s.bolts) {
    const Interaction action = interaction_of(now, bolts_[at(k)], base_.displacement(end_s_));
    add_row(s, ruled_bolt(now, bolts_[at(k)], base_.displacement(end_s_)), action, action.force);
  }
  s.sweeps.let_act();
  return true;
}

void Solid::add_row(IslandSystem& s, const Ruled& ruled, const Interaction& action, const Eigen::Vector2d& force) {
  ForceSweeps::Row& row = s.sweeps.add_row();
  row.apart = ruled.apart;
  row.rule = ruled.rule;
  row.force = force;
  for (const bool second : {false, true}) {
    const int block = action.block(second);
    if (!moves(block)) continue;
    const Matrix26 shape = (second ? -1 : 1) * action.shape(placement_[at(block)], second);
    const auto k = at(local_[at(block)]);
    const auto first = s.unknowns->first[k];
    if (s.unknowns->shared()) {
      add_end_of_mesh(s, second, static_cast<int>(k), shape);
    } else if (s.unknowns->count[k] == 3) {
      const Eigen::Matrix<double, 2, 3> motions = shape.leftCols<3>();
      s.sweeps.add_end(second, first, motions,
                       matrix_[at(block)].topLeftCorner<3, 3>().llt().solve(motions.transpose()));
    } else {
      s.sweeps.add_end(second, first, shape, matrix_[at(block)].llt().solve(shape.transpose()));
    }
  }
}

/// Unknowns that blocks share: those of all the blocks that move with this one.
void Solid::add_end_of_mesh(IslandSystem& s, bool second, int k, const Matrix26& shape) {
  Eigen::Matrix2Xd motions = Eigen::Matrix2Xd::Zero(2, s.unknowns->total);
  Eigen::MatrixX2d responses(s.unknowns->total, 2);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(s.unknowns->total);
    s.unknowns->add(k, shape.row(axis).transpose(), pull);
    motions.row(axis) = pull.transpose();
    responses.col(axis) = solve_again(s, pull);
  }
  Eigen::Index first = 0;
  Eigen::Index last = s.unknowns->total - 1;
  while (first < last && responses.row(first).isZero(0)) ++first;
  while (last > first && responses.row(last).isZero(0)) --last;
  const Eigen::Index count = last - first + 1;
  s.sweeps.add_end(second, first, motions.middleCols(first, count), responses.middleRows(first, count));
}

/// Forces found act at the trial, with their states.
void Solid::take_forces(IslandSystem& s) {
  const Trial now = trial();
  const std::size_t contacts = s.island.contacts.size();
  const std::size_t supports = s.island.supports.size();
  s.actions.resize(contacts + supports + s.bolts.size());
  const auto& rows = s.sweeps.rows();
  for (std::size_t i = 0; i < contacts; ++i) {
    const int k = s.island.contacts[i];
    s.actions[i] = formulation_->take_contact(now, k, contacts_[at(k)], {rows[i].force, rows[i].slips});
  }
  for (std::size_t i = 0; i < supports; ++i) {
    const int k = s.island.supports[i];
    s.actions[contacts + i] = formulation_->take_support(now, k, supports_[at(k)], rows[contacts + i].force);
  }
  for (std::size_t i = 0; i < s.bolts.size(); ++i) {
    Interaction& action = s.actions[contacts + supports + i];
    action = interaction_of(now, bolts_[at(s.bolts[i])], base_.displacement(end_s_));
    action.force = rows[contacts + supports + i].force;
  }
}

/// What an action's end on a moving base adds to its gap and slip in a second, beyond the step's mean.
Eigen::Vector2d Solid::rate_of_fixed(const Interaction& action, bool to_mean, double dt) const {
  Eigen::Vector2d rate = Eigen::Vector2d::Zero();
  for (const bool second : {false, true}) {
    const int block = action.block(second);
    if (block < 0 || moves(block)) continue;
    Vector6 beyond = states_[at(block)].velocity;
    if (to_mean) beyond -= increment_[at(block)] / dt;
    rate += (second ? -1 : 1) * (action.shape(placement_[at(block)], second) * beyond);
  }
  return rate;
}

/// Velocities along held directions become those of what holds them, as settle_held_velocities() has it.
void Solid::settle_swept_velocities(IslandSystem& s, double dt) {
  constexpr int most = 20;
  constexpr double unheard_m_per_s = 1e-9;
  const bool to_mean = scene_.analysis.integrator == scene::Integrator::shi || !newmark_.damps;
  Eigen::VectorXd& beyond = s.correction;  // what velocities have beyond those that are due
  beyond.setZero();
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    const auto b = at(s.island.blocks[k]);
    Vector6 rate = states_[b].velocity;
    if (to_mean) rate -= (blocks_[b].is_part() ? corner_increment(b) : increment_[b]) / dt;
    const auto& numbers = s.unknowns->of(static_cast<int>(k));
    for (std::size_t i = 0; i < numbers.size(); ++i) beyond[numbers[i]] = rate[static_cast<Eigen::Index>(i)];
  }
  const Eigen::VectorXd before = beyond;
  auto& rows = s.sweeps.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ForceSweeps::Row& row = rows[i];
    const bool held = !row.rule.opens || !row.force.isZero(0);
    const bool bolt = i >= s.actions.size() - s.bolts.size();
    const bool sticks = held && !row.slips;
    row.apart = rate_of_fixed(s.actions[i], to_mean, dt);
    if (!to_mean && i >= s.island.contacts.size() && !bolt) row.apart -= led_rate(s, i, dt);
    const double opening = i < s.island.contacts.size() ? opening_slope(s, i) : 0;
    row.rule = {.opens = false, .opening = {opening, opening}};
    row.rule.least_normal = -(row.rule.most_normal = held && !bolt ? ForceRule::unbounded : 0);
    row.rule.cohesion = sticks && !bolt ? ForceRule::unbounded : 0;
    row.force.setZero();
  }
  s.sweeps.displace(beyond);
  for (int sweep = 0; sweep < most && s.sweeps.sweep() > unheard_m_per_s; ++sweep) {
  }
  const Eigen::VectorXd change = s.sweeps.displacement() - before;
  for (std::size_t k = 0; k < s.island.blocks.size(); ++k) {
    states_[at(s.island.blocks[k])].velocity += s.unknowns->take_own(static_cast<int>(k), change);
  }
}

}  // namespace blockweir::solid
