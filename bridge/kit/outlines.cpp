// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/kit/outlines.hpp"

#include <stdexcept>

#include "bridge/wire/placement.hpp"

namespace blockweir::kit {
namespace {

/// Of a polygon, about its first vertex.
std::array<double, 2> centroid(const double* xy, std::size_t count) {
  double twice_area = 0;
  double sx = 0;
  double sy = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % count;
    const double ax = xy[2 * i] - xy[0];
    const double ay = xy[2 * i + 1] - xy[1];
    const double bx = xy[2 * j] - xy[0];
    const double by = xy[2 * j + 1] - xy[1];
    const double cross = ax * by - bx * ay;
    twice_area += cross;
    sx += (ax + bx) * cross;
    sy += (ay + by) * cross;
  }
  return {xy[0] + sx / (3 * twice_area), xy[1] + sy / (3 * twice_area)};
}

}  // namespace

Outlines::Outlines(const wire::Hello& hello) : numbers_(hello.vertices_m) {
  std::size_t next = 0;
  for (const std::uint32_t count : hello.vertex_counts) {
    if (count < 3 || next + 2 * std::size_t{count} > numbers_.size()) break;
    first_.push_back(next);
    count_.push_back(count);
    centroid_.push_back(centroid(numbers_.data() + next, count));
    next += 2 * std::size_t{count};
  }
  if (next != numbers_.size() || first_.size() != hello.block_names.size()) {
    throw std::invalid_argument("the solid sent blocks whose outlines do not fit their number");
  }
}

void Outlines::place(std::size_t block, const std::array<double, 6>& displacement, double* xy) const {
  const Eigen::Vector2d middle(centroid_[block][0], centroid_[block][1]);
  const double* from = outline(block);
  for (std::size_t i = 0; i < count_[block]; ++i) {
    const Eigen::Vector2d now = wire::place(middle, displacement, Eigen::Vector2d(from[2 * i], from[2 * i + 1]));
    xy[2 * i] = now.x();
    xy[2 * i + 1] = now.y();
  }
}

}  // namespace blockweir::kit
