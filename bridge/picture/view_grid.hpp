// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons of a picture in Clipper's integers.
#pragma once

#include <Eigen/Core>
#include <polyclipping/clipper.hpp>
#include <vector>

#include "bridge/picture/view.hpp"

namespace blockweir::picture {

/// Metres in view to Clipper's integers and back: 1e8 of them in the view's longer side.
class ViewGrid {
 public:
  explicit ViewGrid(const View& view);
  [[nodiscard]] ClipperLib::IntPoint on(const Eigen::Vector2d& p) const;
  [[nodiscard]] Eigen::Vector2d metres(const ClipperLib::IntPoint& p) const;
  static constexpr double closed = 1e5;  ///< narrower gaps between blocks show no water

 private:
  Eigen::Vector2d origin_;
  double per_m_;
};

/// The pieces of a polygon that are in view [m].
std::vector<std::vector<Eigen::Vector2d>> in_view(const std::vector<Eigen::Vector2d>& outline, const View& view);

}  // namespace blockweir::picture
