// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/force_rule.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::solid {
namespace {

double within(const ForceRule& rule, double normal) {
  return std::min(std::max(normal, rule.least_normal), rule.most_normal);
}

double shear_bound(const ForceRule& rule, double normal) {
  return std::max(0.0, rule.cohesion + rule.friction * normal);
}

/// What forces do to the gap and the slip, compliance among it.
struct Flexibility {
  double gap_by_normal;
  double gap_by_shear;
  double slip_by_shear;
};

/// Shear of this sign at its bound: the normal force that then closes the gap, unless the slip is to the wrong side.
bool slips(const ForceRule& rule, const Flexibility& W, const Eigen::Vector2d& apart, double side,
           Eigen::Vector2d& force) {
  const double opening = rule.opening[side > 0 ? 1 : 0];
  // The gap that the contact resists is gap - opening * slip.
  const double by_shear = W.gap_by_shear - opening * W.slip_by_shear;
  const double by_normal = W.gap_by_normal - opening * W.gap_by_shear + side * rule.friction * by_shear;
  if (by_normal <= 0) return false;
  const double without = apart[0] - opening * apart[1] + by_shear * side * rule.cohesion;
  const double normal = within(rule, -without / by_normal);
  const double shear = side * shear_bound(rule, normal);
  const double slip = apart[1] + W.gap_by_shear * normal + W.slip_by_shear * shear;
  force = {normal, shear};
  return side * slip <= 0;
}

}  // namespace

RuledForce forces_of(const ForceRule& rule, const Eigen::Matrix2d& flexibility, const Eigen::Vector2d& apart) {
  const double opened = rule.opening[apart[1] > 0 ? 0 : 1] * apart[1];
  if (rule.opens && apart[0] >= opened && rule.least_normal == 0) return {};
  const Flexibility W{flexibility(0, 0) + rule.compliance[0], flexibility(1, 0),
                      flexibility(1, 1) + rule.compliance[1]};
  const double per = 1 / (W.gap_by_normal * W.slip_by_shear - W.gap_by_shear * W.gap_by_shear);
  const double free_normal = (W.gap_by_shear * apart[1] - W.slip_by_shear * apart[0]) * per;
  const double normal = within(rule, free_normal);
  const double shear = normal == free_normal ? (W.gap_by_shear * apart[0] - W.gap_by_normal * apart[1]) * per
                                             : -(apart[1] + W.gap_by_shear * normal) / W.slip_by_shear;
  if (std::abs(shear) <= shear_bound(rule, normal)) return {{normal, shear}, false};
  const double side = shear < 0 ? -1 : 1;
  RuledForce found{{0, 0}, true};
  if (slips(rule, W, apart, side, found.force) || slips(rule, W, apart, -side, found.force)) return found;
  found.force = {within(rule, -apart[0] / W.gap_by_normal), 0};
  return found;
}

}  // namespace blockweir::solid
