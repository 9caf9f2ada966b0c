// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of one island at the end of a step: Newton's method on (5)-(6) with the open-close states inside,
// multipliers swept (8) each time it has converged.
#include <algorithm>
#include <cmath>

#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/solve/condition_number.hpp"
#include "solid/step/solid.hpp"
#include "solid/step/temporarily.hpp"

namespace blockweir::solid {
namespace {

/// Notices that Newton's method runs in circles: what is unbalanced comes again (Brent's way to find a cycle).
class Circle {
 public:
  bool closes(double unbalanced) {
    if (std::abs(unbalanced - seen_) <= 1e-9 * seen_) return true;
    if (++since_ == wait_) {
      seen_ = unbalanced;
      wait_ *= 2;
      since_ = 0;
    }
    return false;
  }

 private:
  double seen_ = -1;
  int since_ = 0;
  int wait_ = 1;
};

}  // namespace

/// Islands, and with them the symbolic factorizations, are kept while the contact graph stands.
void Solid::prepare_islands() {
  const Stopwatch watch(profile_.islands);
  std::vector<std::pair<int, int>> links;
  links.reserve(contacts_.size() + bolts_.size());
  for (const ContactPoint& c : contacts_) links.emplace_back(c.vertex_part, c.edge_part);
  for (const Bolt& bolt : bolts_) {
    if (bolt.part[1] >= 0 && !frozen_[at(bolt.part[0])] && !frozen_[at(bolt.part[1])]) {
      links.emplace_back(bolt.part[0], bolt.part[1]);
    }
  }
  const bool stand = links == links_;
  if (stand && !islands_.empty()) return;
  links_ = std::move(links);
  std::vector<int> support_blocks;
  for (const Support& s : supports_) support_blocks.push_back(s.block);
  std::vector<std::pair<int, int>> joined;
  for (const StrainCoupling& c : parts_.couplings) joined.emplace_back(c.i, c.j);
  islands_.clear();
  std::vector<std::size_t> island_of(blocks_.size());
  std::vector<Island> found = find_islands(frozen_, links_, support_blocks, joined);
  if (!scene_.analysis.islands) found = {join(found)};
  counts_.most_islands = std::max(counts_.most_islands, static_cast<long>(found.size()));
  for (Island& island : found) {
    std::vector<int> counts;
    std::vector<std::array<int, 3>> nodes;
    for (const int b : island.blocks) {
      counts.push_back(blocks_[at(b)].unknowns());
      nodes.push_back(blocks_[at(b)].nodes);
      island_of[at(b)] = islands_.size();
    }
    islands_.emplace_back(std::move(island), std::make_unique<Unknowns>(counts, nodes));
  }
  for (std::size_t c = 0; c < parts_.couplings.size(); ++c) {
    const auto part = at(parts_.couplings[c].i);
    if (!frozen_[part]) islands_[island_of[part]].couplings.push_back(static_cast<int>(c));
  }
  give_bolts_to_islands();
  for (const IslandSystem& s : islands_) {
    for (std::size_t k = 0; k < s.island.blocks.size(); ++k) local_[at(s.island.blocks[k])] = static_cast<int>(k);
  }
  find_incidences();
  if (stand && kept_.size() == islands_.size()) {
    for (std::size_t i = 0; i < islands_.size(); ++i) islands_[i].system->restore(kept_[i]);
  }
  kept_.clear();
}

/// Links beyond those of contacts were bolts' own; a bolt belongs to the island of what moves at its ends.
void Solid::give_bolts_to_islands() {
  const auto contacts = static_cast<int>(contacts_.size());
  std::vector<std::size_t> island_of(blocks_.size(), islands_.size());
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    std::erase_if(islands_[i].island.contacts, [&](int k) { return k >= contacts; });
    for (const int b : islands_[i].island.blocks) island_of[at(b)] = i;
  }
  for (std::size_t k = 0; k < bolts_.size(); ++k) {
    for (const int b : bolts_[k].part) {
      if (b < 0 || island_of[at(b)] == islands_.size()) continue;
      islands_[island_of[at(b)]].bolts.push_back(static_cast<int>(k));
      break;
    }
  }
}

/// Of all that acts in an island, as the residual has it: contacts, supports, bolts.
void Solid::find_incidences() {
  const auto number = [this](int b) { return b < 0 || frozen_[at(b)] ? -1 : local_[at(b)]; };
  for (IslandSystem& s : islands_) {
    std::vector<std::pair<int, int>> ends;
    for (const int k : s.island.contacts) ends.emplace_back(contacts_[at(k)].vertex_part, contacts_[at(k)].edge_part);
    for (const int k : s.island.supports) ends.emplace_back(supports_[at(k)].block, -1);
    for (const int k : s.bolts) ends.emplace_back(bolts_[at(k)].part[0], bolts_[at(k)].part[1]);
    for (auto& [a, b] : ends) a = number(a), b = number(b);
    s.incidence = Incidence(s.island.blocks.size(), ends);
  }
}

bool Solid::find_equilibrium(IslandSystem& s, const StepMode& mode) {
  if (mode.friction_lags) return find_equilibrium_with_lagging_friction(s, mode);
  // A large island whose states run in circles shows it by then; trying on costs a small one little, and may find out.
  // In the largest a solution costs several of those by Cholesky that find states while friction lags.
  const int unknowns = s.unknowns->total;
  const int most_in_a_row = unknowns > 10 * large_island ? 15
                            : unknowns > large_island    ? 50
                                                         : scene_.contact.max_iterations;
  // Where it has failed, its next turn is a short one.
  const int large = may_sweep(mode) ? few_unknowns : large_island;
  const int most = unknowns > large && whole_law_.after_failure() ? 20 : scene_.contact.max_iterations;
  const double tolerance = formulation_->settings().force_tolerance_n;
  constexpr double close = 0.3;  // of what multipliers will still move: they need no closer equilibrium
  const Held held = held_by(s);
  int in_a_row = 0;  // solves since the last sweep
  double first = 0;  // unbalanced as they began
  Circle circle;
  for (int iteration = 0; iteration < most; ++iteration) {
    const double left = unbalanced(s);
    if (!std::isfinite(left)) {
      // Of redundant multipliers the forces may overflow: the substitute has none.
      if (!formulation_->solves_for_forces()) require_numbers(s);
      return false;
    }
    if (left <= tolerance || left <= close * formulation_->unsettled(held)) {
      if (update_multipliers(s)) return true;
      circle = {};
      in_a_row = 0;
      first = unbalanced_in_these_states(s, mode);
    } else if (iteration > 0) {
      if (circle.closes(left)) return false;
      ++in_a_row;
    } else {
      first = left;
    }
    const bool diverges = unknowns > 10 * large_island && in_a_row > 2 && left > 1e3 * first;
    if (diverges || in_a_row > most_in_a_row || !correct(s)) return false;
  }
  return false;
}

/// What the search finds, or the island's trial as it was.
bool Solid::or_undone(IslandSystem& s, const std::function<bool()>& search) {
  std::vector<ContactMemory> contacts;
  std::vector<Support> supports;
  std::vector<Vector6> increments;
  std::vector<Point> nodes;
  for (const int k : s.island.contacts) contacts.push_back(contacts_[at(k)]);
  for (const int k : s.island.supports) supports.push_back(supports_[at(k)]);
  for (const int b : s.island.blocks) increments.push_back(increment_[at(b)]);
  for (const auto& [node, first] : s.unknowns->nodes) nodes.push_back(node_increment_[at(node)]);
  if (search()) return true;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    static_cast<ContactMemory&>(contacts_[at(s.island.contacts[i])]) = contacts[i];
  }
  for (std::size_t i = 0; i < supports.size(); ++i) supports_[at(s.island.supports[i])] = supports[i];
  for (std::size_t i = 0; i < nodes.size(); ++i) node_increment_[at(s.unknowns->nodes[i].first)] = nodes[i];
  for (std::size_t i = 0; i < increments.size(); ++i) {
    const auto b = at(s.island.blocks[i]);
    increment_[b] = increments[i];
    placement_[b] = Placement(blocks_[b].centroid, states_[b].displacement + increment_[b]);
  }
  if (formulation_->settings().friction_lags) formulation_->lag_friction(held_by(s));
  return false;
}

/// Multipliers that took the penalties' part have put all out of balance, and no state in question: a solution in the
/// states that contacts have spares those in which hundreds of them would change and change back. While a structure
/// settles all are judged, or what has slipped once would go on, and bonds beside it break that can hold it.
double Solid::unbalanced_in_these_states(IslandSystem& s, const StepMode& mode) {
  const Temporarily stand(formulation_->settings().states_stand, !mode.settles);
  return unbalanced(s);
}

/// What a large island's velocities are is round-off where they would move it by no more: with penalties times
/// that, a wall that stands would be out of balance as each step begins.
void Solid::start_where_it_rests(const IslandSystem& s) {
  const double round_off_m = 10 * formulation_->settings().position_round_off_m;
  if (s.unknowns->total <= large_island || s.unknowns->shared()) return;
  for (const int block : s.island.blocks) {
    const auto b = at(block);
    const double moved = increment_[b].head<2>().norm() + blocks_[b].radius * increment_[b].tail<4>().norm();
    if (moved > round_off_m) continue;
    increment_[b].setZero();
    placement_[b] = start_[b];
  }
}

/// Multipliers (8), then bonds: false where one of them has changed.
bool Solid::update_multipliers(IslandSystem& s) {
  const Stopwatch watch(profile_.sweeps);
  ++counts_.sweeps;
  return formulation_->sweep(held_by(s)) &&
         (formulation_->settings().joints_held ||
          !break_bonds(laws_, formulation_->settings().force_tolerance_n, blocks_, s.island.contacts, contacts_));
}

/// One solution of the linearized equations, added to the trial.
bool Solid::correct(IslandSystem& s) {
  if (!solve_linearized(s)) return false;
  move(s, 1);
  return true;
}

bool Solid::solve_linearized(IslandSystem& s) {
  if (s.unknown_forces.empty()) assemble(s);
  const Stopwatch watch(profile_.solve);
  if (s.unknown_forces.empty()) {
    const SolutionTimes before = s.system->times();
    if (!solve(s, s.symmetric)) return false;
    profile_.factorization += s.system->times().factorization - before.factorization;
    profile_.refinement += s.system->times().refinement - before.refinement;
    ++(s.system->reused() ? counts_.reused_factorizations : counts_.factorizations);
  } else {
    if (!s.saddle.solve(s.residual, s.correction, s.forces)) return false;
    correct_forces(s);
  }
  ++counts_.iterations;
  if (meanwhile_) meanwhile_();
  if (scene_.contact.measure_condition) {
    counts_.condition_number = std::max(
        counts_.condition_number, condition_number(s.unknown_forces.empty() ? s.system->dense() : s.saddle.dense()));
  }
  return true;
}

/// Adds so much of the correction to the trial.
void Solid::move(IslandSystem& s, double fraction) {
  for (const auto& [node, first] : s.unknowns->nodes) {
    node_increment_[at(node)] += fraction * s.correction.segment<2>(first);
  }
  for_each(s.island.blocks.size(), [&](std::size_t k) {
    const auto b = at(s.island.blocks[k]);
    if (blocks_[b].is_part()) return follow_corners(b);
    increment_[b] += fraction * s.unknowns->take(static_cast<int>(k), s.correction);
    placement_[b] = Placement(blocks_[b].centroid, states_[b].displacement + increment_[b]);
  });
}

void Solid::correct_forces(IslandSystem& s) {
  std::size_t next = 0;  // of the unknown forces; those of a contact or support follow each other
  const auto force_of = [&](bool support, int index) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (; next < s.unknown_forces.size(); ++next) {
      const UnknownForce& unknown = s.unknown_forces[next];
      if (unknown.support != support || unknown.index != index) break;
      sum += s.forces[static_cast<Eigen::Index>(next)] * unknown.force;
    }
    return sum;
  };
  for (const int k : s.island.contacts) formulation_->correct_contact(k, contacts_[at(k)], force_of(false, k));
  for (const int k : s.island.supports) formulation_->correct_support(k, supports_[at(k)], force_of(true, k));
}

}  // namespace blockweir::solid
