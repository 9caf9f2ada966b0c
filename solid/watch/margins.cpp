// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/at.hpp"
#include "solid/contact/outline.hpp"

namespace blockweir::solid {
namespace {

/// What the contacts of one surface bear together, along the line from end to end: where some press on other faces
/// there, as a heel on level ground beside its dipping base, forces count by their parts along that line.
class SurfaceSum {
 public:
  /// First of all contacts: how far they reach.
  void reach(const Point& place) {
    const auto before = [](const Point& p, const Point& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); };
    if (before(place, low_)) low_ = place;
    if (before(high_, place)) high_ = place;
  }
  [[nodiscard]] double length_m() const { return (high_ - low_).norm(); }
  [[nodiscard]] Point across() const { return perpendicular(Point(high_ - low_)) / length_m(); }

  /// `force`: on the block above the line; `pushed`: the part of it that is normal to the contact's own edge.
  void add(const Strength& law, const Point& force, const Point& pushed, const Point& place) {
    const double pressed = across().dot(force);
    cohesion_ += law.cohesion;
    friction_ += law.friction * pressed;
    shear_ += cross(across(), force);
    buttress_ += cross(across(), pushed);
    normal_ += pressed;
    pressed_or_pulled_ += force.norm();
    moment_ += pressed * place;
  }

  [[nodiscard]] double strength() const { return std::max(0.0, cohesion_ + friction_); }
  [[nodiscard]] bool is_sheared() const {
    return std::abs(shear_) > negligible * (std::abs(strength()) + std::abs(normal_));
  }
  /// Does a face askew to the line, as level ground before the toe of a base that dips downstream, resist the slide?
  [[nodiscard]] bool is_buttressed() const {
    return buttress_ * shear_ > 0 && std::abs(buttress_) > seen * std::abs(shear_);
  }
  [[nodiscard]] bool is_pressed() const { return normal_ > negligible * pressed_or_pulled_; }
  [[nodiscard]] double sliding_factor() const { return strength() / std::abs(shear_); }
  /// Of the resultant from the nearer end, over the surface's length; negative outside.
  [[nodiscard]] double end_distance() const { return std::min(from_left(), 1 - from_left()); }
  [[nodiscard]] const char* nearer_end(bool wet) const {
    constexpr double upright = 1e-3;
    const Point along = high_ - low_;
    const bool at_low = from_left() < 0.5;
    if (std::abs(along.x()) < upright * along.norm()) return at_low == (along.y() > 0) ? "lower" : "upper";
    if (at_low) return wet ? "upstream" : "left";
    return wet ? "downstream" : "right";
  }

 private:
  [[nodiscard]] double from_left() const {
    const Point along = high_ - low_;
    return along.dot(moment_ / normal_ - low_) / along.squaredNorm();
  }

  static constexpr double negligible = 1e-6;
  static constexpr double seen = 1e-2;  // what strains turn faces by resists less
  Point low_ = Point::Constant(std::numeric_limits<double>::infinity());
  Point high_ = -low_;
  double cohesion_ = 0;
  double friction_ = 0;
  double shear_ = 0;
  double buttress_ = 0;  ///< of the shear, what faces askew to the line push
  double normal_ = 0;
  double pressed_or_pulled_ = 0;  ///< sum of the forces' sizes
  Point moment_ = Point::Zero();  ///< sum of normal force times place
};

/// Force on the block whose centre lies farther to this side, and the part of it that is normal to the edge.
std::pair<Point, Point> force_on_side(const Solid& solid, const ContactPoint& c, const Point& side) {
  const Placement& edge = solid.placements()[at(c.edge_part)];
  const Point t = edge.vector(c.edge_to - c.edge_from).normalized();
  const Point pushed = c.force.x() * Point(t.y(), -t.x());
  const Point on_vertex = pushed + c.force.y() * t;
  const auto& blocks = solid.placements();
  const Point between = blocks[at(c.vertex_block)].centre() - blocks[at(c.edge_block)].centre();
  return side.dot(between) > 0 ? std::pair(on_vertex, pushed) : std::pair<Point, Point>(-on_vertex, -pushed);
}

}  // namespace

void Margins::look(const Solid& solid, double time_s, double level_m) {
  if (!surfaces_) surfaces_.emplace(solid);
  std::vector<SurfaceSum> sums(surfaces_->names().size());
  for (const ContactPoint& c : solid.contacts()) {
    for (const int surface : surfaces_->of(c.pair())) sums[at(surface)].reach(solid.place(c));
  }
  const auto is_point = [&](const SurfaceSum& sum) { return sum.length_m() <= 1e-6 * solid.size_m(); };
  for (const ContactPoint& c : solid.contacts()) {
    if (c.state == ContactState::open) continue;
    for (const int surface : surfaces_->of(c.pair())) {
      SurfaceSum& sum = sums[at(surface)];
      if (is_point(sum)) continue;
      const auto [force, pushed] = force_on_side(solid, c, sum.across());
      sum.add(solid.laws()[c.law].strength(c.bond, c.bond_length), force, pushed, solid.place(c));
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const auto keep_lowest = [&](std::optional<Margin>& lowest, double value, const char* end = "") {
      if (lowest && lowest->value <= value) return;
      lowest = Margin{value, time_s, level_m, surfaces_->names()[i], end};
    };
    if (sums[i].is_sheared()) {
      if (sums[i].is_buttressed()) {
        buttressed_ = true;
      } else {
        keep_lowest(sliding_, sums[i].sliding_factor());
      }
    }
    if (sums[i].is_pressed()) {
      keep_lowest(overturning_, sums[i].end_distance(), sums[i].nearer_end(!std::isnan(level_m)));
    }
  }
}

}  // namespace blockweir::solid
