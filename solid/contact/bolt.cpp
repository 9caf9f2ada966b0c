// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/bolt.hpp"

#include <cmath>

namespace blockweir::solid {
namespace {

Point end_of(const Trial& trial, const Bolt& bolt, std::size_t end, const Point& ground_displacement) {
  const int b = bolt.part[end];
  if (b < 0) return bolt.material[end] + ground_displacement;
  return trial.placement[static_cast<std::size_t>(b)].position(bolt.material[end]);
}

}  // namespace

Bolt make_bolt(const scene::Bolt& described, const MovingParts& parts) {
  Bolt bolt{.described = &described, .material = {described.from_m, described.to_m}};
  bolt.drawn_length_m = (described.to_m - described.from_m).norm();
  for (std::size_t end = 0; end < 2; ++end) {
    if (described.blocks[end] < 0) continue;
    const Anchor anchor = parts.anchor(described.blocks[end], bolt.material[end]);
    bolt.part[end] = anchor.part;
    bolt.material[end] = anchor.material;
  }
  bolt.acting = bolt_force(bolt, 0);
  return bolt;
}

BoltForce bolt_force(const Bolt& bolt, double elongation_m) {
  const scene::Bolt& d = *bolt.described;
  const double elastic = d.prestress_n_per_m + d.stiffness_n_per_m2 * (elongation_m - bolt.plastic_m);
  if (!d.takes_compression && elastic < 0) return {0, 0, BoltState::slack};
  if (d.yield_n_per_m && std::abs(elastic) > *d.yield_n_per_m) {
    return {std::copysign(*d.yield_n_per_m, elastic), 0, BoltState::yielding};
  }
  return {elastic, d.stiffness_n_per_m2, BoltState::elastic};
}

Interaction interaction_of(const Trial& trial, const Bolt& bolt, const Point& ground_displacement) {
  const Point from = end_of(trial, bolt, 0, ground_displacement);
  const Point to = end_of(trial, bolt, 1, ground_displacement);
  const double length = (from - to).norm();
  const Point along = (from - to) / length;
  const BoltForce acting = bolt_force(bolt, length - bolt.drawn_length_m);
  Interaction action{.block_i = bolt.part[0],
                     .block_j = bolt.part[1],
                     .at_i = bolt.material[0],
                     .at_j = bolt.material[1],
                     .axis = along};
  action.force = {-acting.tension_n_per_m, 0};
  action.stiffness(0, 0) = acting.slope_n_per_m2;
  action.stiffness(1, 1) = acting.tension_n_per_m / length;
  action.round_off = separation_round_off * bolt.described->stiffness_n_per_m2 * (from.norm() + to.norm());
  return action;
}

Ruled ruled_bolt(const Trial& trial, const Bolt& bolt, const Point& ground_displacement) {
  const scene::Bolt& d = *bolt.described;
  const double length =
      (end_of(trial, bolt, 0, ground_displacement) - end_of(trial, bolt, 1, ground_displacement)).norm();
  const double most = d.yield_n_per_m.value_or(ForceRule::unbounded);
  ForceRule rule{.least_normal = -most, .most_normal = d.takes_compression ? most : 0, .opens = false};
  rule.compliance.x() = 1 / d.stiffness_n_per_m2;
  return {{d.prestress_n_per_m / d.stiffness_n_per_m2 + length - bolt.drawn_length_m - bolt.plastic_m, 0}, rule};
}

void accept(const Trial& trial, const Point& ground_displacement, Bolt& bolt) {
  const scene::Bolt& d = *bolt.described;
  bolt.elongation_m =
      (end_of(trial, bolt, 0, ground_displacement) - end_of(trial, bolt, 1, ground_displacement)).norm() -
      bolt.drawn_length_m;
  bolt.acting = bolt_force(bolt, bolt.elongation_m);
  if (bolt.acting.state == BoltState::yielding) {
    bolt.plastic_m = bolt.elongation_m - (bolt.acting.tension_n_per_m - d.prestress_n_per_m) / d.stiffness_n_per_m2;
  }
}

}  // namespace blockweir::solid
