// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/force_rule.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace blockweir::solid {
namespace {

double within(const ForceRule& rule, double normal) {
  return std::clamp(normal, rule.least_normal, rule.most_normal);
}

double shear_bound(const ForceRule& rule, double normal) {
  return std::max(0.0, rule.cohesion + rule.friction * normal);
}

/// Shear of this sign at its bound: the normal force that then closes the gap, unless the slip is to the wrong side.
std::optional<Eigen::Vector2d> slipping(const ForceRule& rule, const Eigen::Matrix2d& W, const Eigen::Vector2d& apart,
                                        double side) {
  const double opening = rule.opening[side > 0 ? 1 : 0];
  // The gap that the contact resists is gap - opening * slip.
  const double by_shear = W(0, 1) - opening * W(1, 1);
  const double by_normal = W(0, 0) - opening * W(1, 0) + side * rule.friction * by_shear;
  if (by_normal <= 0) return std::nullopt;
  const double without = apart[0] - opening * apart[1] + by_shear * side * rule.cohesion;
  const double normal = within(rule, -without / by_normal);
  const double shear = side * shear_bound(rule, normal);
  const double slip = apart[1] + W(1, 0) * normal + W(1, 1) * shear;
  if (side * slip > 0) return std::nullopt;
  return Eigen::Vector2d(normal, shear);
}

}  // namespace

RuledForce forces_of(const ForceRule& rule, const Eigen::Matrix2d& flexibility, const Eigen::Vector2d& apart) {
  const double opened = rule.opening[apart[1] > 0 ? 0 : 1] * apart[1];
  if (rule.opens && apart[0] >= opened && rule.least_normal == 0) return {};
  Eigen::Matrix2d W = flexibility;
  W.diagonal() += rule.compliance;
  const double determinant = W(0, 0) * W(1, 1) - W(0, 1) * W(1, 0);
  Eigen::Vector2d stuck =
      Eigen::Vector2d(W(0, 1) * apart[1] - W(1, 1) * apart[0], W(1, 0) * apart[0] - W(0, 0) * apart[1]) / determinant;
  if (const double normal = within(rule, stuck[0]); normal != stuck[0]) {
    stuck = {normal, -(apart[1] + W(1, 0) * normal) / W(1, 1)};
  }
  if (std::abs(stuck[1]) <= shear_bound(rule, stuck[0])) return {stuck, false};
  for (const double side : {std::copysign(1.0, stuck[1]), -std::copysign(1.0, stuck[1])}) {
    if (const auto force = slipping(rule, W, apart, side)) return {*force, true};
  }
  return {{within(rule, -apart[0] / W(0, 0)), 0}, true};
}

}  // namespace blockweir::solid
