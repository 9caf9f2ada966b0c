// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/block_index.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>

namespace blockweir::scene {
namespace {

namespace bg = boost::geometry;
using BoxCorner = bg::model::d2::point_xy<double>;
using BlockBox = bg::model::box<BoxCorner>;
using Entry = std::pair<BlockBox, std::size_t>;

BlockBox box(const geometry::Bounds& b) {
  return {BoxCorner(b.low.x(), b.low.y()), BoxCorner(b.high.x(), b.high.y())};
}

std::vector<Entry> entries(const std::vector<Block>& blocks) {
  std::vector<Entry> all;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (!blocks[i].vertices.empty()) all.emplace_back(box(geometry::bounds_of(blocks[i].vertices)), i);
  }
  return all;
}

}  // namespace

struct BlockIndex::Tree {
  bg::index::rtree<Entry, bg::index::linear<16>> entries;
};

BlockIndex::BlockIndex(const std::vector<Block>& blocks) : tree_(std::make_unique<Tree>()) {
  tree_->entries = decltype(tree_->entries)(entries(blocks));
}

BlockIndex::~BlockIndex() = default;

std::vector<std::size_t> BlockIndex::meeting(const geometry::Bounds& bounds) const {
  std::vector<Entry> found;
  tree_->entries.query(bg::index::intersects(box(bounds)), std::back_inserter(found));
  std::vector<std::size_t> blocks;
  blocks.reserve(found.size());
  for (const Entry& entry : found) blocks.push_back(entry.second);
  return blocks;
}

void BlockIndex::forget(std::size_t i, const Block& block) {
  tree_->entries.remove(Entry{box(geometry::bounds_of(block.vertices)), i});
}

}  // namespace blockweir::scene
