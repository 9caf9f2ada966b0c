// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of contact forces over a surface that runs through the structure.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "solid/contact/outline.hpp"
#include "solid/watch/surfaces.hpp"

namespace blockweir::solid {

/// Forces of one surface's contacts, along the line from end to end. If some act on other faces, such as a heel on
/// level ground beside a dipping base, only their components along that line count.
class SurfaceSum {
 public:
  /// Call first, for all contacts: finds the ends of the surface.
  void reach(const Point& place) {
    const auto before = [](const Point& p, const Point& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); };
    if (before(place, low_)) low_ = place;
    if (before(high_, place)) high_ = place;
  }
  [[nodiscard]] const Point& upstream_end() const { return low_; }
  [[nodiscard]] const Point& downstream_end() const { return high_; }
  [[nodiscard]] double length_m() const { return (high_ - low_).norm(); }
  [[nodiscard]] Point across() const { return perpendicular(Point(high_ - low_)) / length_m(); }

  /// `residual`: the law after the bond is broken. `force`: on the block above the line; `pushed`: its part normal to
  /// the contact's own edge.
  void add(const Strength& law, const Strength& residual, const Point& force, const Point& pushed, const Point& place) {
    const double pressed = across().dot(force);
    residual_ += residual.cohesion + residual.shear_of_friction(pressed);
    cohesion_ += law.cohesion;
    friction_ += law.shear_of_friction(pressed);
    shear_ += cross(across(), force);
    buttress_ += cross(across(), pushed);
    normal_ += pressed;
    pressed_or_pulled_ += force.norm();
    pulled_ += std::max(0.0, -pressed);
    moment_ += pressed * place;
  }

  /// Length that a contact holds by cohesion or tension strength, weighted by what remains of them.
  void add_bond(double length_m) { bonded_m_ = bonded_m_.value_or(0) + length_m; }
  /// None where no joint of the surface has a bond.
  [[nodiscard]] const std::optional<double>& bonded_length_m() const { return bonded_m_; }

  [[nodiscard]] double strength() const { return std::max(0.0, cohesion_ + friction_); }
  [[nodiscard]] bool is_sheared() const {
    return std::abs(shear_) > negligible * (std::abs(strength()) + std::abs(normal_));
  }
  /// Whether a face oblique to the line resists the slide, such as level ground at the toe of a dipping base.
  [[nodiscard]] bool is_buttressed() const {
    return buttress_ * shear_ > 0 && std::abs(buttress_) > seen * std::abs(shear_);
  }
  [[nodiscard]] bool is_pressed() const { return normal_ > negligible * pressed_or_pulled_; }
  /// Whether a bond is in tension anywhere.
  [[nodiscard]] bool is_pulled() const { return pulled_ > negligible * pressed_or_pulled_; }
  /// Whether it carries the weight above it. Otherwise something else does, such as a corner that leans on a neighbour.
  [[nodiscard]] bool bears(double weight_n_per_m) const {
    constexpr double noticed = 1e-3;
    return std::hypot(normal_, shear_) > noticed * weight_n_per_m;
  }
  [[nodiscard]] double normal_n_per_m() const { return normal_; }
  [[nodiscard]] double shear_n_per_m() const { return shear_; }
  [[nodiscard]] double sliding_factor() const { return strength() / std::abs(shear_); }
  [[nodiscard]] double residual_sliding_factor() const { return std::max(0.0, residual_) / std::abs(shear_); }
  /// Distance of the resultant from the nearer end, over the surface's length; negative outside.
  [[nodiscard]] double end_distance() const {
    const double s = resultant_from_downstream();
    return std::min(s, 1 - s);
  }
  /// Whether that is almost zero or less. A surface in pure compression has its resultant inside.
  [[nodiscard]] bool ends_at_nothing() const { return end_distance() <= negligible; }
  /// Name of that end; `wet`: water is upstream, on the left.
  [[nodiscard]] const char* nearer_end(bool wet) const {
    constexpr double upright = 1e-3;
    const Point along = high_ - low_;
    const bool at_low = resultant_from_downstream() > 0.5;
    if (std::abs(along.x()) < upright * along.norm()) return at_low == (along.y() > 0) ? "lower" : "upper";
    if (at_low) return wet ? "upstream" : "left";
    return wet ? "downstream" : "right";
  }
  /// Distance from the downstream end, over the surface's length.
  [[nodiscard]] double resultant_from_downstream() const {
    const Point along = high_ - low_;
    return along.dot(high_ - moment_ / normal_) / along.squaredNorm();
  }

 private:
  static constexpr double negligible = 1e-6;
  static constexpr double seen = 1e-2;  // faces rotated by strain resist less
  Point low_ = Point::Constant(std::numeric_limits<double>::infinity());
  Point high_ = -low_;
  std::optional<double> bonded_m_;
  double cohesion_ = 0;
  double friction_ = 0;
  double residual_ = 0;  ///< strength after the bond is broken
  double shear_ = 0;
  double buttress_ = 0;  ///< part of the shear that oblique faces resist
  double normal_ = 0;
  double pressed_or_pulled_ = 0;  ///< sum of the absolute forces
  double pulled_ = 0;             ///< sum of tensile forces, normal to the line
  Point moment_ = Point::Zero();  ///< sum of normal force times position
};

/// For each surface, by its index.
std::vector<SurfaceSum> surface_sums(const Solid& solid, const Surfaces& surfaces);

}  // namespace blockweir::solid
