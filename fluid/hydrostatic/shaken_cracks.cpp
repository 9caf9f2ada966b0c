// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/shaken_cracks.hpp"

#include <algorithm>
#include <limits>

#include "bridge/scene/at.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/wire/placement.hpp"

namespace blockweir::hydrostatic {
namespace {

using scene::Point;

constexpr double infinite = std::numeric_limits<double>::infinity();

double end_of(const scene::TimeTable& acceleration) {
  if (acceleration.sine || acceleration.value.back() != 0) return infinite;
  return acceleration.value.size() == 1 ? -infinite : acceleration.time_s.back();
}

/// The block across the joint from a place on an edge; -1 where the crack has none there.
int opposite(const scene::Crack& crack, int block, int edge, double s) {
  for (const scene::CrackPart& part : crack.parts) {
    for (const scene::TracePiece& p : part.trace.pieces) {
      const auto within = [&](double from, double to) { return s >= std::min(from, to) && s <= std::max(from, to); };
      if (part.block_a == block && p.edge_a == edge && within(p.s_from_a, p.s_to_a)) return part.block_b;
      if (part.block_b == block && p.edge_b == edge && within(p.s_from_b, p.s_to_b)) return part.block_a;
    }
  }
  return -1;
}

}  // namespace

double shaking_ends_s(const scene::Scene& scene) {
  if (!scene.base_motion) return -infinite;
  return std::max(end_of(scene.base_motion->acceleration_x_m_per_s2),
                  end_of(scene.base_motion->acceleration_y_m_per_s2));
}

void empty_open_panels(const scene::Scene& scene, const scene::Crack& crack, const std::vector<Point>& centroids,
                       const wire::Motion& motion, std::size_t first, wire::Load& load) {
  const double open_m = 1e-6 * scene::structure_size_m(scene.blocks);
  for (std::size_t i = first; i < load.block.size(); ++i) {
    const std::size_t own = load.block[i];
    const double s = (load.s_from[i] + load.s_to[i]) / 2;
    const int other = opposite(crack, static_cast<int>(own), static_cast<int>(load.edge[i]), s);
    if (other < 0) continue;
    const auto& outline = scene.blocks[own].vertices;
    const Point& from = outline[load.edge[i]];
    const Point& to = outline[(load.edge[i] + 1) % outline.size()];
    const auto place = [&](std::size_t b, const Point& drawn) {
      return Point(wire::place(centroids[b], motion.displacement[b], drawn));
    };
    const Point along = (place(own, to) - place(own, from)).normalized();
    const Point outwards(along.y(), -along.x());
    const Point middle = from + s * (to - from);
    if (outwards.dot(place(at(other), middle) - place(own, middle)) <= open_m) continue;
    load.pressure_from_pa.own()[i] = 0;
    load.pressure_to_pa.own()[i] = 0;
  }
}

}  // namespace blockweir::hydrostatic
