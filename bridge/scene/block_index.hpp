// SPDX-License-Identifier: GPL-3.0-or-later
// Finds blocks by their bounding boxes, so that checks of pairs stay fast for many blocks.
#pragma once

#include <vector>

#include "bridge/geometry/box_index.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

class BlockIndex {
 public:
  /// Blocks without vertices are left out.
  explicit BlockIndex(const std::vector<Block>& blocks) : boxes_(boxes_of(blocks)) {}

  /// Blocks whose bounding boxes touch or overlap `bounds`.
  [[nodiscard]] std::vector<std::size_t> meeting(const geometry::Bounds& bounds) const {
    return boxes_.meeting(bounds);
  }

  /// Removes a block from the index.
  void forget(std::size_t i, const Block& block) { boxes_.forget({geometry::bounds_of(block.vertices), i}); }

 private:
  static std::vector<geometry::BoxIndex::Entry> boxes_of(const std::vector<Block>& blocks) {
    std::vector<geometry::BoxIndex::Entry> boxes;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (!blocks[i].vertices.empty()) boxes.emplace_back(geometry::bounds_of(blocks[i].vertices), i);
    }
    return boxes;
  }

  geometry::BoxIndex boxes_;
};

}  // namespace blockweir::scene
