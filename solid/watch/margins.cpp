// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

/// What the contacts of one surface bear together.
struct SurfaceSum {
  double strength = 0;
  double shear = 0;
  double normal = 0;
  double pressed_or_pulled = 0;  ///< sum of the normal forces' sizes
  Point moment = Point::Zero();  ///< sum of normal force times place
  Point low =
      Point::Constant(std::numeric_limits<double>::infinity());  ///< ends of the surface, as far as contacts reach
  Point high = -low;

  void add(const ContactPoint& c, const JointProperties& law, const Point& place) {
    const auto before = [](const Point& p, const Point& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); };
    if (before(place, low)) low = place;
    if (before(high, place)) high = place;
    if (c.state == ContactState::open) return;
    const Strength here = law.strength(c.bond, c.bond_length);
    strength += std::max(0.0, here.cohesion + c.force.x() * here.friction);
    // Shear is counted along the edge of one block: seen from the other it keeps its sign.
    shear += c.force.y();
    normal += c.force.x();
    pressed_or_pulled += std::abs(c.force.x());
    moment += c.force.x() * place;
  }
  /// Of the resultant from the nearer end, over the surface's length; negative outside.
  [[nodiscard]] double end_distance() const {
    const Point along = high - low;
    const double s = along.dot(moment / normal - low) / along.squaredNorm();
    return std::min(s, 1 - s);
  }
};

}  // namespace

void Margins::look(const Solid& solid, double time_s, double level_m) {
  constexpr double negligible = 1e-6;
  if (!surfaces_) surfaces_.emplace(solid);
  std::vector<SurfaceSum> sums(surfaces_->names().size());
  for (const ContactPoint& c : solid.contacts()) {
    for (const int surface : surfaces_->of(c.pair())) sums[at(surface)].add(c, solid.laws()[c.law], solid.place(c));
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const SurfaceSum& sum = sums[i];
    const auto keep_lowest = [&](std::optional<Margin>& lowest, double value) {
      if (lowest && lowest->value <= value) return;
      lowest = Margin{value, time_s, level_m, surfaces_->names()[i]};
    };
    if (std::abs(sum.shear) > negligible * (std::abs(sum.strength) + std::abs(sum.normal))) {
      keep_lowest(sliding_, sum.strength / std::abs(sum.shear));
    }
    if (sum.normal > negligible * sum.pressed_or_pulled && (sum.high - sum.low).norm() > negligible * solid.size_m()) {
      keep_lowest(overturning_, sum.end_distance());
    }
  }
}

}  // namespace blockweir::solid
