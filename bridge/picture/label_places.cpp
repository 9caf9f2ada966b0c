// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/label_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blockweir::picture {
namespace {

LabelPlaces::Box around(const LabelPlaces::Point& middle, const LabelPlaces::Point& size) {
  return {middle - size / 2, middle + size / 2};
}

}  // namespace

LabelPlaces::Point LabelPlaces::within(const Point& middle, const Point& size) const {
  const Point lowest = frame_.low + size / 2;
  return middle.cwiseMin(frame_.high - size / 2).cwiseMax(lowest);
}

bool LabelPlaces::is_free(const Box& box) const {
  return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
    return (box.low.array() < other.high.array()).all() && (other.low.array() < box.high.array()).all();
  });
}

LabelPlaces::Point LabelPlaces::place(const Point& wanted, const Point& size) {
  constexpr int rings = 60;
  constexpr int directions = 16;
  Point best = within(wanted, size);
  const auto look = [&] {
    for (int ring = 0; ring <= rings; ++ring) {
      for (int d = 0; d < (ring == 0 ? 1 : directions); ++d) {
        const double angle = 2 * std::numbers::pi * (d + 0.5) / directions;
        const Point away = size.y() * ring / 3 * Point(std::cos(angle), std::sin(angle));
        const Point middle = within(wanted + away, size);
        if (is_free(around(middle, size))) return middle;
      }
    }
    return best;
  };
  best = look();
  taken_.push_back(around(best, size));
  return best;
}

}  // namespace blockweir::picture
