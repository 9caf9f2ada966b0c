// SPDX-License-Identifier: GPL-3.0-or-later
// Finds blocks by their bounding boxes, so that checks of pairs stay fast for many blocks.
#pragma once

#include <memory>
#include <vector>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

class BlockIndex {
 public:
  /// Blocks without vertices are left out.
  explicit BlockIndex(const std::vector<Block>& blocks);
  ~BlockIndex();

  /// Blocks whose bounding boxes touch or overlap `bounds`.
  [[nodiscard]] std::vector<std::size_t> meeting(const geometry::Bounds& bounds) const;

  /// Removes a block from the index.
  void forget(std::size_t i, const Block& block);

 private:
  struct Tree;  ///< of Boost.Geometry, which takes seconds to compile
  std::unique_ptr<Tree> tree_;
};

}  // namespace blockweir::scene
