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

bool is_free(const LabelPlaces::Box& box, const std::vector<LabelPlaces::Box>& taken) {
  return std::none_of(taken.begin(), taken.end(), [&](const LabelPlaces::Box& other) {
    return (box.low.array() < other.high.array()).all() && (other.low.array() < box.high.array()).all();
  });
}

}  // namespace

LabelPlaces::Point LabelPlaces::within(const Point& middle, const Point& size) const {
  const Point lowest = frame_.low + size / 2;
  return middle.cwiseMin(frame_.high - size / 2).cwiseMax(lowest);
}

std::optional<LabelPlaces::Point> LabelPlaces::nearest(const Point& wanted, const Point& size, double far,
                                                       bool off_lines) const {
  const double step = size.y() / 3;
  for (int ring = 0; ring * step <= far; ++ring) {
    const int directions = ring == 0 ? 1 : std::max(16, 4 * ring);
    for (int d = 0; d < directions; ++d) {
      const double angle = 2 * std::numbers::pi * (d + 0.5) / directions;
      const Point middle = within(wanted + ring * step * Point(std::cos(angle), std::sin(angle)), size);
      const Box box = around(middle, size);
      if (is_free(box, labels_) && (!off_lines || is_free(box, avoided_))) return middle;
    }
  }
  return std::nullopt;
}

std::optional<LabelPlaces::Point> LabelPlaces::place(const Point& wanted, const Point& size) {
  constexpr double nearby = 8;  // heights of the label
  const Point room = frame_.high - frame_.low;
  if ((size.array() > room.array()).any()) return std::nullopt;
  std::optional<Point> middle = nearest(wanted, size, nearby * size.y(), /*off_lines=*/true);
  if (!middle) middle = nearest(wanted, size, room.sum(), /*off_lines=*/false);
  if (middle) labels_.push_back(around(*middle, size));
  return middle;
}

}  // namespace blockweir::picture
