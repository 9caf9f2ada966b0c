// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/bounded_force.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::solid {

bool BoundedForce::fits(const ForceRule& rule) {
  return rule.most_normal == ForceRule::unbounded && rule.compliance.isZero(0) && rule.opening[0] == 0 &&
         rule.opening[1] == 0;
}

BoundedForce::BoundedForce(const ForceRule& rule, const Eigen::Vector2d& force, double least)
    : count_(rule.cohesion > 0 ? 3 : 2),
      friction_(rule.friction),
      cohesion_(rule.cohesion),
      tension_(bonded() ? -rule.least_normal : 0) {
  auto& [minus, plus, pulled] = distances_;
  if (bonded()) {
    const double normal = std::max(force.x(), least - tension_);
    const double bound = friction_ * normal + cohesion_;
    const double most = std::max(0.0, bound - 2 * least);
    const double shear = std::clamp(force.y(), -most, most);
    minus.force = (bound - shear) / 2;
    plus.force = (bound + shear) / 2;
    pulled.force = normal + tension_;
  } else {
    const double half = force.x() / 2;
    const double skewed = friction_ > 0 ? force.y() / (2 * friction_) : 0;
    minus.force = std::max(half - skewed, least);
    plus.force = std::max(half + skewed, least);
  }
  for (ComplementaryPair& p : distances()) p.motion = 1 / p.force;
}

Eigen::Vector2d BoundedForce::force() const {
  const auto& [minus, plus, pulled] = distances_;
  if (bonded()) return {pulled.force - tension_, plus.force - minus.force};
  return {minus.force + plus.force, friction_ * (plus.force - minus.force)};
}

Eigen::Matrix2d BoundedForce::stiffness() const {
  const auto& [minus, plus, pulled] = distances_;
  const double f = friction_;
  Eigen::Matrix2d k;
  if (!bonded()) {
    const double a = minus.stiffness();
    const double b = plus.stiffness();
    k << a + b, f * (b - a), f * (b - a), f * f * (a + b);
    return k;
  }
  const double a = 1 / (4 * minus.stiffness());
  const double b = 1 / (4 * plus.stiffness());
  const double c = 1 / pulled.stiffness();
  k << a + b, f * (a - b), f * (a - b), f * f * (a + b) + c;
  return k / (4 * f * f * a * b + c * (a + b));
}

Eigen::Vector2d BoundedForce::change_at_rest(double product) const {
  const auto aim = [&](const ComplementaryPair& p) { return (product - p.product_change) / p.force; };
  const auto& [minus, plus, pulled] = distances_;
  const double f = friction_;
  if (bonded()) {
    const auto [a, b] = std::array{aim(minus) / 2, aim(plus) / 2};
    return stiffness() * Eigen::Vector2d(f * (a + b) + aim(pulled), b - a);
  }
  const auto [a, b] = std::array{minus.stiffness() * aim(minus), plus.stiffness() * aim(plus)};
  return {a + b, f * (b - a)};
}

void BoundedForce::set_changes(double product, const Eigen::Vector2d& motion) {
  motion_ = motion;
  auto& [minus, plus, pulled] = distances_;
  if (!bonded()) {  // each distance has its own motion
    const double opens = friction_ * motion.y();
    minus.motion_change = motion.x() - opens - minus.motion;
    plus.motion_change = motion.x() + opens - plus.motion;
    for (ComplementaryPair& p : distances()) p.force_change = p.stiffness() * (p.lacks(product) - p.motion_change);
    return;
  }
  const Eigen::Vector2d change = change_at_rest(product) - stiffness() * motion;
  minus.force_change = (friction_ * change.x() - change.y()) / 2;
  plus.force_change = (friction_ * change.x() + change.y()) / 2;
  pulled.force_change = change.x();
  for (ComplementaryPair& p : distances()) p.motion_change = p.lacks(product) - p.force_change / p.stiffness();
}

double BoundedForce::closes() const {
  const double slips = friction_ * motion_.y();
  return std::max(0.0, slips - motion_.x()) + std::max(0.0, -slips - motion_.x());
}

double BoundedForce::resists() const {
  return tension_ * motion_.x() + (cohesion_ - friction_ * tension_) * std::abs(motion_.y());
}

}  // namespace blockweir::solid
