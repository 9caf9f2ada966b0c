// SPDX-License-Identifier: GPL-3.0-or-later
// How far blocks are in each other, from their outlines alone.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace blockweir::test {

using Outline = std::vector<Eigen::Vector2d>;

/// Of two convex outlines, counter-clockwise: the least shift that parts them [m], 0 where they do not meet.
inline double overlap_m(const Outline& a, const Outline& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Outline* of : {&a, &b}) {
    const Outline& other = of == &a ? b : a;
    for (std::size_t i = 0; i < of->size(); ++i) {
      const Eigen::Vector2d from = (*of)[i];
      const Eigen::Vector2d along = ((*of)[(i + 1) % of->size()] - from).normalized();
      double deepest = -std::numeric_limits<double>::infinity();
      for (const Eigen::Vector2d& p : other) {
        deepest = std::max(deepest, along.x() * (p - from).y() - along.y() * (p - from).x());
      }
      least = std::min(least, deepest);
    }
  }
  return std::max(0.0, least);
}

/// Of any two [m].
inline double largest_overlap_m(const std::vector<Outline>& outlines) {
  double largest = 0;
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> boxes;
  for (const Outline& outline : outlines) {
    Eigen::Vector2d low = outline[0];
    Eigen::Vector2d high = outline[0];
    for (const Eigen::Vector2d& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
    boxes.emplace_back(low, high);
  }
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t j = i + 1; j < outlines.size(); ++j) {
      const bool apart = (boxes[i].first.array() > boxes[j].second.array()).any() ||
                         (boxes[j].first.array() > boxes[i].second.array()).any();
      if (!apart) largest = std::max(largest, overlap_m(outlines[i], outlines[j]));
    }
  }
  return largest;
}

}  // namespace blockweir::test
