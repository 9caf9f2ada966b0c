// SPDX-License-Identifier: GPL-3.0-or-later
// Where labels of a picture stand: within its frame, none over another, and off its lines where there is room nearby.
#pragma once

#include <Eigen/Core>
#include <optional>
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

  /// What no label is to cover if it can stand beside.
  void keep_free(const Box& box) { lines_.push_back(box); }
  /// Middle of the free place nearest to `wanted` for a label of this size, which is taken then; nothing where all is
  /// full.
  std::optional<Point> place(const Point& wanted, const Point& size);

 private:
  [[nodiscard]] Point within(const Point& middle, const Point& size) const;
  [[nodiscard]] std::optional<Point> nearest(const Point& wanted, const Point& size, double far, bool off_lines) const;

  Box frame_;
  std::vector<Box> labels_;
  std::vector<Box> lines_;
};

}  // namespace blockweir::picture
