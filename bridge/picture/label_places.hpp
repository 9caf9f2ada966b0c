// SPDX-License-Identifier: GPL-3.0-or-later
// Where labels of a picture stand: within its frame, and none over another.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace blockweir::picture {

/// All in the picture's units, y upwards.
class LabelPlaces {
 public:
  using Point = Eigen::Vector2d;
  struct Box {
    Point low;
    Point high;
  };

  explicit LabelPlaces(const Box& frame) : frame_(frame) {}

  /// What no label is to cover.
  void keep_free(const Box& box) { taken_.push_back(box); }
  /// Middle of the free place nearest to `wanted` for a label of this size, which is taken then; where all is full, the
  /// nearest within the frame.
  Point place(const Point& wanted, const Point& size);

 private:
  [[nodiscard]] Point within(const Point& middle, const Point& size) const;
  [[nodiscard]] bool is_free(const Box& box) const;

  Box frame_;
  std::vector<Box> taken_;
};

}  // namespace blockweir::picture
