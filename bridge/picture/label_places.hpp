// SPDX-License-Identifier: GPL-3.0-or-later
// Places labels in a picture: inside the frame, without overlap, and off its lines if there is room nearby.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace blockweir::picture {

/// All in the units of the picture, y upwards.
class LabelPlaces {
 public:
  using Point = Eigen::Vector2d;
  struct Box {
    Point low;
    Point high;
  };

  explicit LabelPlaces(const Box& frame) : frame_(frame) {}

  /// A region that labels avoid if possible.
  void keep_free(const Box& box) { avoided_.push_back(box); }
  /// Centre of the free place nearest to `wanted` for a label of this size, which is then occupied; none if there is no
  /// room.
  std::optional<Point> place(const Point& wanted, const Point& size);

 private:
  [[nodiscard]] Point within(const Point& middle, const Point& size) const;
  [[nodiscard]] std::optional<Point> nearest(const Point& wanted, const Point& size, double far, bool off_lines) const;

  Box frame_;
  std::vector<Box> labels_;
  std::vector<Box> avoided_;
};

}  // namespace blockweir::picture
