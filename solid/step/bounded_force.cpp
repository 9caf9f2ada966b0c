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
    : open_(false),
      bonded_(rule.cohesion > 0),
      friction_(rule.friction),
      cohesion_(rule.cohesion),
      tension_(bonded_ ? -rule.least_normal : 0) {
  if (!bonded_) {
    const double half = force.x() / 2;
    const double skewed = friction_ > 0 ? force.y() / (2 * friction_) : 0;
    distance_ = {std::max(half - skewed, least), std::max(half + skewed, least), 0};
    return;
  }
  const double normal = std::max(force.x(), least - tension_);
  const double bound = friction_ * normal + cohesion_;
  const double most = std::max(0.0, bound - 2 * least);
  const double shear = std::clamp(force.y(), -most, most);
  distance_ = {(bound - shear) / 2, (bound + shear) / 2, normal + tension_};
}

Eigen::Vector2d BoundedForce::force() const {
  const auto& [minus, plus, pulled] = std::array{distance_[0], distance_[1], distance_[2]};
  if (bonded_) return {pulled - tension_, plus - minus};
  return {minus + plus, friction_ * (plus - minus)};
}

Eigen::Matrix2d BoundedForce::squares() const {
  const double f = friction_;
  Eigen::Matrix2d k;
  if (!bonded_) {
    const double a = distance_[0] * distance_[0];
    const double b = distance_[1] * distance_[1];
    k << a + b, f * (b - a), f * (b - a), f * f * (a + b);
    return k;
  }
  const double a = 1 / (4 * distance_[0] * distance_[0]);
  const double b = 1 / (4 * distance_[1] * distance_[1]);
  const double c = 1 / (distance_[2] * distance_[2]);
  k << a + b, f * (a - b), f * (a - b), f * f * (a + b) + c;
  return k / (4 * f * f * a * b + c * (a + b));
}

Eigen::Vector2d BoundedForce::to_centre() const {
  if (!bonded_) return force();
  const auto [a, b, c] = std::array{0.5 / distance_[0], 0.5 / distance_[1], 1 / distance_[2]};
  return squares() * Eigen::Vector2d(friction_ * (a + b) + c, b - a);
}

void BoundedForce::set_motion(const Eigen::Vector2d& motion) {
  motion_ = motion;
  if (!bonded_) {
    const auto [minus, plus] = std::array{distance_[0], distance_[1]};
    change_ = {minus - minus * minus * (motion.x() - friction_ * motion.y()),
               plus - plus * plus * (motion.x() + friction_ * motion.y()), 0};
    return;
  }
  const Eigen::Vector2d change = to_centre() - squares() * motion;
  change_ = {(friction_ * change.x() - change.y()) / 2, (friction_ * change.x() + change.y()) / 2, change.x()};
}

double BoundedForce::lost() const {
  const double of_shear = std::max(-change_[0] / distance_[0], -change_[1] / distance_[1]);
  return bonded_ ? std::max(of_shear, -change_[2] / distance_[2]) : of_shear;
}

void BoundedForce::change(double fraction) {
  distance_ += fraction * change_;
}

double BoundedForce::closes() const {
  const double slips = friction_ * motion_.y();
  return std::max(0.0, slips - motion_.x()) + std::max(0.0, -slips - motion_.x());
}

double BoundedForce::resists() const {
  return tension_ * motion_.x() + (cohesion_ - friction_ * tension_) * std::abs(motion_.y());
}

}  // namespace blockweir::solid
