// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of the two forces of a contact, support or bolt, and the forces that satisfy them with all other forces fixed.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace blockweir::solid {

/// Normal force within its bounds, shear within cohesion + normal * friction. A force inside its bounds closes its gap
/// or slip, apart from its compliance: apart + compliance * force = 0.
struct ForceRule {
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  double friction = 0;                                   ///< tangent
  double cohesion = 0;                                   ///< N per metre
  double least_normal = 0;                               ///< N per metre
  double most_normal = unbounded;                        ///< N per metre
  bool opens = true;                                     ///< at its least normal force it has no shear either
  Eigen::Vector2d compliance = Eigen::Vector2d::Zero();  ///< m per N per metre; 0: what closes is hard
  std::array<double, 2> opening = {0, 0};                ///< d gap / d slip under shear of negative, positive sign
};

/// A force that is to be found: gap and slip that it resists, less what the trial moves beyond it [m].
struct Ruled {
  Eigen::Vector2d apart = Eigen::Vector2d::Zero();
  ForceRule rule{};
};

/// Forces (normal, shear) and whether the shear is at its bound.
struct RuledForce {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  bool slips = false;
};

/// The forces that fulfil a rule at one point, found time and again: what does not depend on gap and slip is computed
/// once.
class PointForces {
 public:
  PointForces() = default;
  /// `flexibility`: d (gap, slip) / d (normal, shear), symmetric and positive, the rule's compliance not among it.
  PointForces(const ForceRule& rule, const Eigen::Matrix2d& flexibility);

  /// Plain numbers: they stay in registers.
  struct Found {
    double normal = 0;
    double shear = 0;
    bool slips = false;
  };
  /// `gap`, `slip`: values without the forces [m]. For one point Coulomb's law has at least one solution if friction
  /// does not jam; if it does, the shear is left out.
  [[nodiscard]] Found at(double gap, double slip) const {
    if (may_open_ && gap >= opening_[slip > 0 ? 0 : 1] * slip) return {};
    const double free_normal = -(stiffness_[0] * gap + stiffness_[1] * slip);
    double normal = free_normal;
    double shear = -(stiffness_[1] * gap + stiffness_[2] * slip);
    if (free_normal < least_normal_ || free_normal > most_normal_) [[unlikely]] {  // predicted branch: no stall
      normal = within(free_normal);
      shear = -(slip + gap_by_shear_ * normal) * shear_per_slip_;
    }
    if (std::abs(shear) <= std::max(0.0, cohesion_ + friction_ * normal)) return {normal, shear, false};
    return at_bound(gap, slip, shear > 0);
  }

 private:
  /// Shear of one sign at its bound.
  struct Slipping {
    double opening = 0;          ///< d gap / d slip
    double gap_by_cohesion = 0;  ///< of the gap that the contact resists, gap - opening * slip
    double normal_per_gap = 0;   ///< that closes it; 0: none does
  };

  [[nodiscard]] double within(double normal) const { return std::min(std::max(normal, least_normal_), most_normal_); }
  [[nodiscard]] Found at_bound(double gap, double slip, bool positive) const {
    Found found{0, 0, true};
    if (slips(gap, slip, positive, found) || slips(gap, slip, !positive, found)) return found;
    return {within(-gap / gap_by_normal_), 0, true};
  }
  /// The normal force that closes the gap while shear of this sign is at its bound, unless the slip is to the wrong
  /// side.
  [[nodiscard]] bool slips(double gap, double slip, bool positive, Found& found) const {
    const Slipping& s = slipping_[positive ? 1 : 0];
    if (s.normal_per_gap == 0) return false;
    const double side = positive ? 1 : -1;
    found.normal = within(-(gap - s.opening * slip + s.gap_by_cohesion) * s.normal_per_gap);
    found.shear = side * std::max(0.0, cohesion_ + friction_ * found.normal);
    return side * (slip + gap_by_shear_ * found.normal + slip_by_shear_ * found.shear) <= 0;
  }

  // In the order in which a visit reads them.
  bool may_open_ = true;
  std::array<double, 2> opening_ = {0, 0};
  std::array<double, 3> stiffness_ = {0, 0, 0};  ///< gap, both, slip
  double least_normal_ = 0;
  double most_normal_ = 0;
  double friction_ = 0;
  double cohesion_ = 0;
  std::array<Slipping, 2> slipping_;
  double gap_by_normal_ = 0;
  double gap_by_shear_ = 0;
  double slip_by_shear_ = 0;
  double shear_per_slip_ = 0;
};

/// Of a point that is asked once.
inline RuledForce forces_of(const ForceRule& rule, const Eigen::Matrix2d& flexibility, const Eigen::Vector2d& apart) {
  const PointForces::Found found = PointForces(rule, flexibility).at(apart[0], apart[1]);
  return {{found.normal, found.shear}, found.slips};
}

}  // namespace blockweir::solid
