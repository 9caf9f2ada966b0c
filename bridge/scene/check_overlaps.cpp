// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that overlap: the common area of outlines whose boxes overlap.
#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry/geometries/polygon.hpp>

#include "bridge/scene/block_index.hpp"
#include "bridge/scene/check.hpp"

namespace blockweir::scene {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, /*ClockWise=*/false>;

constexpr double depth_ratio = 1e-6;  ///< what is shallower counts as touching: coordinates in files are rounded

BoostPolygon boost_polygon(const Block& block, const Point& origin) {
  BoostPolygon polygon;
  for (const Point& p : block.vertices) bg::append(polygon.outer(), BoostPoint(p.x() - origin.x(), p.y() - origin.y()));
  bg::correct(polygon);
  return polygon;
}

/// Pieces that both blocks cover, relative to `origin`, without those shallower than `tolerance`.
std::vector<BoostPolygon> common_area(const Block& a, const Block& b, const Point& origin, double tolerance) {
  std::vector<BoostPolygon> pieces;
  bg::intersection(boost_polygon(a, origin), boost_polygon(b, origin), pieces);
  std::erase_if(pieces, [&](const BoostPolygon& piece) {
    return 2 * bg::area(piece) <= tolerance * bg::perimeter(piece);  // the depth of a slender piece
  });
  return pieces;
}

void check_pair(const Block& a, const Block& b, Problems& problems) {
  const Bounds box_a = bounds_of(a.vertices);
  const Bounds box_b = bounds_of(b.vertices);
  const double tolerance = depth_ratio * std::min(box_a.size(), box_b.size());
  const Point depth = box_a.high.cwiseMin(box_b.high) - box_a.low.cwiseMax(box_b.low);
  if (depth.minCoeff() <= tolerance) return;
  // About a near origin, so that far-away blocks lose no digits.
  const Point origin = box_a.low;
  const auto pieces = common_area(a, b, origin, tolerance);
  if (pieces.empty()) return;
  double area = 0;
  for (const BoostPolygon& piece : pieces) area += bg::area(piece);
  BoostPoint middle;
  bg::centroid(pieces.front(), middle);
  problems.error(problems.at(std::max(a.line, b.line)),
                 fmt::format("blocks \"{}\" and \"{}\" overlap by {:.4g} m2 near ({:.4g}, {:.4g})", a.name, b.name,
                             area, middle.x() + origin.x(), middle.y() + origin.y()),
                 "blocks that at most touch", "move the vertices of one of them to the common boundary");
}

}  // namespace

void check_overlaps(const Scene& scene, Problems& problems) {
  const BlockIndex index(scene.blocks);
  for (std::size_t i = 0; i < scene.blocks.size() && !problems.full(); ++i) {
    const Block& block = scene.blocks[i];
    if (block.vertices.empty()) continue;
    std::vector<std::size_t> near = index.meeting(bounds_of(block.vertices));
    std::sort(near.begin(), near.end());
    for (const std::size_t j : near) {
      if (j <= i || problems.full()) continue;
      try {
        check_pair(block, scene.blocks[j], problems);
      } catch (const bg::exception& exception) {
        problems.error(problems.at(std::max(block.line, scene.blocks[j].line)),
                       fmt::format("blocks \"{}\" and \"{}\" cannot be intersected ({})", block.name,
                                   scene.blocks[j].name, exception.what()),
                       "outlines that coincide or are clearly apart", "round the coordinates of both alike");
      }
    }
  }
}

}  // namespace blockweir::scene
