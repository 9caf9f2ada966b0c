// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of the two forces of a contact, support or bolt, and the forces that satisfy them with all other forces fixed.
#pragma once

#include <Eigen/Core>
#include <array>
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

  /// That of a dry joint that slips without opening.
  [[nodiscard]] bool is_dry() const {
    return cohesion == 0 && least_normal == 0 && most_normal == unbounded && compliance.isZero(0) && opening[0] == 0 &&
           opening[1] == 0;
  }
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
  bool exact = false;  ///< nothing is left of the slip of what sticks
};

/// The forces that fulfil a rule at one point, found time and again: what does not depend on gap and slip is computed
/// once. Of one point (a number) or of several at a time (a vector of numbers), to the same bits: all cases are
/// computed, and the right one is taken.
template <class T>
class PointForces {
 public:
  using Mask = decltype(T{} < T{});
  struct Found {
    T normal{};
    T shear{};
    Mask slips{};
  };
  /// The numbers of a rule, and d (gap, slip) / d (normal, shear), symmetric and positive, with the rule's compliance.
  struct Law {
    T friction{};
    T cohesion{};
    T least_normal{};
    T most_normal{};
    T opens{};  ///< above zero: it does
    std::array<T, 2> opening{};
    T gap_by_normal{};
    T gap_by_shear{};
    T slip_by_shear{};
  };

  PointForces() = default;
  explicit PointForces(const Law& law) : law_(law) {
    const T one = T{} + 1.0;
    const T per = one / (law.gap_by_normal * law.slip_by_shear - law.gap_by_shear * law.gap_by_shear);
    stiffness_ = {law.slip_by_shear * per, -law.gap_by_shear * per, law.gap_by_normal * per};
    shear_per_slip_ = one / law.slip_by_shear;
    normal_per_gap_ = one / law.gap_by_normal;
    for (const int k : {0, 1}) {
      const double side = side_of(k);
      Slipping& s = slipping_[k];
      const T by_shear = law.gap_by_shear - law.opening[k] * law.slip_by_shear;
      const T by_normal = law.gap_by_normal - law.opening[k] * law.gap_by_shear + side * law.friction * by_shear;
      s.gap_by_cohesion = law.cohesion > T{} ? by_shear * side * law.cohesion : T{};
      s.normal_per_gap = by_normal > T{} ? one / by_normal : T{};
    }
  }

  /// `gap`, `slip`: values without the forces [m]. For one point Coulomb's law has at least one solution if friction
  /// does not jam; if it does, the shear is left out. `dry`: the rule is (ForceRule::is_dry), which takes less.
  template <bool dry = false>
  [[nodiscard, gnu::always_inline]] Found at(const T& gap, const T& slip) const {
    const T none{};
    const T free_normal = -(stiffness_[0] * gap + stiffness_[1] * slip);
    const T free_shear = -(stiffness_[1] * gap + stiffness_[2] * slip);
    const T normal = within<dry>(free_normal);
    const T shear = normal == free_normal ? free_shear : -(slip + law_.gap_by_shear * normal) * shear_per_slip_;
    const Slip minus = slipping<dry>(0, gap, slip);
    const Slip plus = slipping<dry>(1, gap, slip);
    const T jammed = within<dry>(-gap * normal_per_gap_);
    const Mask to_plus = plus.fits & ((shear > none) | (minus.fits == Mask{}));
    const Mask sticks = magnitude(shear) <= bound<dry>(normal);
    Mask opens = law_.opens > none;
    if constexpr (dry) {
      opens &= gap >= none;
    } else {
      opens &= gap >= (slip > none ? law_.opening[0] : law_.opening[1]) * slip;
    }
    return {opens        ? none
            : sticks     ? normal
            : to_plus    ? plus.normal
            : minus.fits ? minus.normal
                         : jammed,
            opens        ? none
            : sticks     ? shear
            : to_plus    ? plus.shear
            : minus.fits ? minus.shear
                         : none,
            (opens | sticks) == Mask{}};
  }

 private:
  /// Shear of one sign at its bound.
  struct Slipping {
    T gap_by_cohesion{};  ///< of the gap that the contact resists, gap - opening * slip
    T normal_per_gap{};   ///< that closes it; 0: none does
  };
  struct Slip {
    T normal{};
    T shear{};
    Mask fits{};  ///< a normal force closes the gap, and the slip is to the right side
  };

  [[nodiscard, gnu::always_inline]] static constexpr double side_of(int k) { return k == 0 ? -1 : 1; }
  [[nodiscard, gnu::always_inline]] static T magnitude(const T& x) { return x < T{} ? -x : x; }
  template <bool dry>
  [[nodiscard, gnu::always_inline]] T within(const T& normal) const {
    if constexpr (dry) return normal < T{} ? T{} : normal;
    const T least = normal < law_.least_normal ? law_.least_normal : normal;
    return law_.most_normal < least ? law_.most_normal : least;
  }
  template <bool dry>
  [[nodiscard, gnu::always_inline]] T bound(const T& normal) const {
    if constexpr (dry) return law_.friction * normal;
    const T shear = law_.cohesion + law_.friction * normal;
    return shear > T{} ? shear : T{};
  }
  template <bool dry>
  [[nodiscard, gnu::always_inline]] Slip slipping(int k, const T& gap, const T& slip) const {
    const Slipping& s = slipping_[k];
    const T resisted = dry ? gap : gap - law_.opening[k] * slip + s.gap_by_cohesion;
    const T normal = within<dry>(-resisted * s.normal_per_gap);
    const T shear = side_of(k) * bound<dry>(normal);
    const T left = side_of(k) * (slip + law_.gap_by_shear * normal + law_.slip_by_shear * shear);
    const Mask fits = (s.normal_per_gap != T{}) & (left <= T{});
    return {normal, shear, fits};
  }

  Law law_;
  std::array<T, 3> stiffness_{};  ///< gap, both, slip
  std::array<Slipping, 2> slipping_{};
  T shear_per_slip_{};
  T normal_per_gap_{};
};

/// Of one point; `flexibility` without the rule's compliance.
[[nodiscard]] inline PointForces<double>::Law law_of(const ForceRule& rule, const Eigen::Matrix2d& flexibility) {
  return {.friction = rule.friction,
          .cohesion = rule.cohesion,
          .least_normal = rule.least_normal,
          .most_normal = rule.most_normal,
          .opens = rule.opens && rule.least_normal == 0 ? 1.0 : 0.0,
          .opening = rule.opening,
          .gap_by_normal = flexibility(0, 0) + rule.compliance[0],
          .gap_by_shear = flexibility(1, 0),
          .slip_by_shear = flexibility(1, 1) + rule.compliance[1]};
}

/// Of a point that is asked once.
[[nodiscard]] inline RuledForce forces_of(const ForceRule& rule, const Eigen::Matrix2d& flexibility,
                                          const Eigen::Vector2d& apart) {
  const auto found = PointForces<double>(law_of(rule, flexibility)).at(apart[0], apart[1]);
  return {.force = {found.normal, found.shear}, .slips = found.slips};
}

}  // namespace blockweir::solid
