// SPDX-License-Identifier: GPL-3.0-or-later
// Finds boxes and points by where they are, in an R-tree.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "bridge/geometry/outline.hpp"

namespace blockweir::geometry {

class BoxIndex {
 public:
  using Entry = std::pair<Bounds, std::size_t>;  ///< a box and its number

  explicit BoxIndex(const std::vector<Entry>& entries);
  /// Of points, whose numbers are their places in the list.
  explicit BoxIndex(const std::vector<Point>& points);
  ~BoxIndex();

  /// Numbers of the boxes that touch or overlap `bounds`.
  [[nodiscard]] std::vector<std::size_t> meeting(const Bounds& bounds) const;
  [[nodiscard]] bool any_meets(const Bounds& bounds) const;
  /// Numbers of the `count` boxes nearest to a point, or of all if there are fewer.
  [[nodiscard]] std::vector<std::size_t> nearest(const Point& p, unsigned count) const;

  /// Removes a box.
  void forget(const Entry& entry);

 private:
  struct Tree;  ///< of Boost.Geometry, which takes seconds to compile
  std::unique_ptr<Tree> tree_;
};

}  // namespace blockweir::geometry
