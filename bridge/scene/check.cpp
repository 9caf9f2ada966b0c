// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <limits>

#include "bridge/scene/polygon.hpp"

namespace blockweir::scene {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, /*ClockWise=*/false>;

BoostPolygon boost_polygon(const Block& block) {
  BoostPolygon polygon;
  for (const Point& p : block.vertices) bg::append(polygon.outer(), BoostPoint(p.x(), p.y()));
  bg::append(polygon.outer(), BoostPoint(block.vertices[0].x(), block.vertices[0].y()));
  return polygon;
}

struct Bounds {
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  double bottom = left;
  double top = -left;

  void include(const Point& p) {
    left = std::min(left, p.x());
    right = std::max(right, p.x());
    bottom = std::min(bottom, p.y());
    top = std::max(top, p.y());
  }
  [[nodiscard]] bool meets(const Bounds& o) const {
    return left <= o.right && o.left <= right && bottom <= o.top && o.bottom <= top;
  }
  [[nodiscard]] double size() const { return std::max(right - left, top - bottom); }
};

Bounds bounds_of(const Block& block) {
  Bounds bounds;
  for (const Point& p : block.vertices) bounds.include(p);
  return bounds;
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point span = b - a;
  const double s = std::clamp(span.dot(p - a) / span.squaredNorm(), 0.0, 1.0);
  return (a + s * span - p).norm();
}

/// Outlines that enclose something and do not meet themselves. True when all are sound.
bool check_outlines(const Scene& scene, Problems& problems) {
  const std::size_t before = problems.errors().size();
  for (const Block& block : scene.blocks) {
    const double size = bounds_of(block).size();
    for (std::size_t i = 0; i < block.vertices.size(); ++i) {
      const Point& p = block.vertices[i];
      if ((p - block.vertices[(i + 1) % block.vertices.size()]).norm() > 1e-9 * size) continue;
      problems.error(block.line, fmt::format("block \"{}\" has the vertex ({}, {}) twice", block.name, p.x(), p.y()),
                     "vertices that differ from their neighbours", "leave one out; the outline closes by itself");
    }
    if (signed_area(block.vertices) <= 1e-12 * size * size) {
      problems.error(block.line, fmt::format("block \"{}\" has no area", block.name), "an outline around something");
    }
    bg::validity_failure_type failure{};
    if (problems.errors().size() == before && !bg::is_valid(boost_polygon(block), failure)) {
      std::string reason;
      bg::is_valid(boost_polygon(block), reason);
      problems.error(block.line, fmt::format("block \"{}\" crosses itself ({})", block.name, reason),
                     "an outline whose edges meet at vertices only", "put the vertices in order along the outline");
    }
  }
  return problems.errors().size() == before;
}

void check_overlaps(const Scene& scene, Problems& problems) {
  std::vector<Bounds> bounds;
  for (const Block& block : scene.blocks) bounds.push_back(bounds_of(block));
  std::vector<std::size_t> by_left(scene.blocks.size());
  for (std::size_t i = 0; i < by_left.size(); ++i) by_left[i] = i;
  std::sort(by_left.begin(), by_left.end(), [&](auto a, auto b) { return bounds[a].left < bounds[b].left; });
  for (std::size_t m = 0; m < by_left.size(); ++m) {
    const std::size_t i = by_left[m];
    for (std::size_t n = m + 1; n < by_left.size() && bounds[by_left[n]].left <= bounds[i].right; ++n) {
      const std::size_t j = by_left[n];
      if (!bounds[i].meets(bounds[j])) continue;
      std::vector<BoostPolygon> common;
      bg::intersection(boost_polygon(scene.blocks[i]), boost_polygon(scene.blocks[j]), common);
      for (const BoostPolygon& piece : common) {
        const double size = std::min(bounds[i].size(), bounds[j].size());
        const double depth = 2 * bg::area(piece) / std::max<double>(bg::perimeter(piece), 1e-300);
        if (depth <= 1e-6 * size) continue;
        BoostPoint middle;
        bg::centroid(piece, middle);
        const auto [first, second] = std::minmax(i, j);
        problems.error(
            scene.blocks[second].line,
            fmt::format("blocks \"{}\" and \"{}\" overlap by {:.4g} m2 near ({:.4g}, {:.4g})", scene.blocks[first].name,
                        scene.blocks[second].name, bg::area(piece), middle.x(), middle.y()),
            "blocks that at most touch", "move a vertex of one of them");
      }
    }
  }
}

/// A block that can move must have something to come to rest on: a fixed block or a support somewhere below its
/// highest point, or a chain of blocks that leads to one, within its own width. Else it would fall for ever.
void check_held(const Scene& scene, Problems& problems) {
  if (scene.analysis.gravity_m_per_s2 == 0) return;
  std::vector<Bounds> bounds;
  std::vector<bool> held;
  for (const Block& block : scene.blocks) {
    bounds.push_back(bounds_of(block));
    held.push_back(block.fixed);
  }
  for (const Support& support : scene.supports) held[static_cast<std::size_t>(support.block)] = true;
  for (bool grew = true; grew;) {
    grew = false;
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (held[i]) continue;
      for (std::size_t j = 0; j < held.size() && !held[i]; ++j) {
        const bool under = held[j] && bounds[j].left <= bounds[i].right && bounds[i].left <= bounds[j].right &&
                           bounds[j].bottom < bounds[i].top;
        if (under) held[i] = grew = true;
      }
    }
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i]) continue;
    problems.error(scene.blocks[i].line,
                   fmt::format("block \"{}\" has nothing under it and would fall for ever", scene.blocks[i].name),
                   "a fixed block or a support below it", "add a foundation with fixed = true");
  }
}

void check_loads(const Scene& scene, Problems& problems) {
  const auto size = [&](int block) { return bounds_of(scene.blocks[static_cast<std::size_t>(block)]).size(); };
  const auto on_block = [&](const char* what, int b, const Point& p) {
    const Block& block = scene.blocks[static_cast<std::size_t>(b)];
    if (bg::distance(BoostPoint(p.x(), p.y()), boost_polygon(block)) <= 1e-6 * size(b)) return;
    problems.error(block.line, fmt::format("{} at ({}, {}) is not on block \"{}\"", what, p.x(), p.y(), block.name),
                   "a point of the block");
  };
  for (const Support& s : scene.supports) on_block("a support", s.block, s.point_m);
  for (const PointLoad& l : scene.point_loads) on_block("a point_load", l.block, l.point_m);
  for (const FacePressure& l : scene.face_pressures) {
    const Block& block = scene.blocks[static_cast<std::size_t>(l.block)];
    bool found = false;
    for (std::size_t e = 0; e < block.vertices.size(); ++e) {
      const Point& a = block.vertices[e];
      const Point& b = block.vertices[(e + 1) % block.vertices.size()];
      found = found || (distance_to_segment(l.from_m, a, b) <= 1e-6 * size(l.block) &&
                        distance_to_segment(l.to_m, a, b) <= 1e-6 * size(l.block));
    }
    if (found) continue;
    problems.error(block.line,
                   fmt::format("face_pressure from ({}, {}) to ({}, {}) does not lie on one edge of block \"{}\"",
                               l.from_m.x(), l.from_m.y(), l.to_m.x(), l.to_m.y(), block.name),
                   "two points of one edge");
  }
}

void check_levels(const Scene& scene, Problems& problems) {
  Bounds structure;
  Bounds all;
  for (const Block& block : scene.blocks) {
    for (const Point& p : block.vertices) {
      all.include(p);
      if (!block.fixed) structure.include(p);
    }
  }
  if (structure.size() < 0) structure = all;
  const auto level = [&](const char* key, const std::optional<TimeTable>& table) {
    if (!table) return;
    if (table->largest() > structure.top && !scene.water.may_overtop) {
      problems.error(0,
                     fmt::format("{} reaches {} m, above the structure's highest point at {} m", key, table->largest(),
                                 structure.top),
                     "a level within the structure", "set [water] may_overtop = true if that is meant");
    }
    if (table->smallest() < all.bottom) {
      problems.error(
          0,
          fmt::format("{} falls to {} m, below the model's lowest point at {} m", key, table->smallest(), all.bottom),
          "a level within the model");
    }
  };
  level("upstream_level_m", scene.water.upstream_level_m);
  level("downstream_level_m", scene.water.downstream_level_m);
}

}  // namespace

void check(const Scene& scene, Problems& problems) {
  if (!check_outlines(scene, problems)) return;
  check_overlaps(scene, problems);
  check_held(scene, problems);
  check_loads(scene, problems);
  check_levels(scene, problems);
}

}  // namespace blockweir::scene
