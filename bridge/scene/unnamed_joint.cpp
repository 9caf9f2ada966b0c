// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/unnamed_joint.hpp"

#include <cmath>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::scene {
namespace {

bool lies_on(const Block& one, const Block& other) {
  if (one.fixed != other.fixed) return other.fixed;
  const Point up = geometry::centroid(one.vertices) - geometry::centroid(other.vertices);
  constexpr double round_off = 1e-9;
  return std::abs(up.y()) > round_off * up.norm() ? up.y() > 0 : up.x() < 0;
}

}  // namespace

std::string unnamed_joint(const Scene& scene, int one, int other) {
  const Block& a = scene.blocks[at(one)];
  const Block& b = scene.blocks[at(other)];
  return lies_on(a, b) ? a.name + " on " + b.name : b.name + " on " + a.name;
}

}  // namespace blockweir::scene
