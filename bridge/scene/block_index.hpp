// SPDX-License-Identifier: GPL-3.0-or-later
// Finds blocks by their bounding boxes, so that checks of pairs stay fast for many blocks.
#pragma once

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>
#include <vector>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

class BlockIndex {
 public:
  /// Blocks without vertices are left out.
  explicit BlockIndex(const std::vector<Block>& blocks) : tree_(entries(blocks)) {}

  /// Blocks whose bounding boxes touch or overlap `bounds`.
  [[nodiscard]] std::vector<std::size_t> meeting(const geometry::Bounds& bounds) const {
    std::vector<Entry> found;
    tree_.query(boost::geometry::index::intersects(box(bounds)), std::back_inserter(found));
    std::vector<std::size_t> blocks;
    blocks.reserve(found.size());
    for (const Entry& entry : found) blocks.push_back(entry.second);
    return blocks;
  }

  /// Removes a block from the index.
  void forget(std::size_t i, const Block& block) { tree_.remove(Entry{box(geometry::bounds_of(block.vertices)), i}); }

 private:
  using Corner = boost::geometry::model::d2::point_xy<double>;
  using Box = boost::geometry::model::box<Corner>;
  using Entry = std::pair<Box, std::size_t>;

  static Box box(const geometry::Bounds& b) { return {Corner(b.low.x(), b.low.y()), Corner(b.high.x(), b.high.y())}; }
  static std::vector<Entry> entries(const std::vector<Block>& blocks) {
    std::vector<Entry> all;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (!blocks[i].vertices.empty()) all.emplace_back(box(geometry::bounds_of(blocks[i].vertices)), i);
    }
    return all;
  }

  boost::geometry::index::rtree<Entry, boost::geometry::index::linear<16>> tree_;
};

}  // namespace blockweir::scene
