// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace blockweir::solid {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

double extent(const Box& box) {
  return box.sizes().maxCoeff();
}

double typical_extent(const std::vector<Box>& boxes) {
  std::vector<double> extents;
  extents.reserve(boxes.size());
  for (const Box& box : boxes) extents.push_back(extent(box));
  const auto middle = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 2);
  std::nth_element(extents.begin(), middle, extents.end());
  return *middle;
}

void add_if_near(const std::vector<Box>& boxes, const std::vector<bool>& movable, int a, int b, Pairs& pairs) {
  const auto i = static_cast<std::size_t>(a);
  const auto j = static_cast<std::size_t>(b);
  if ((movable[i] || movable[j]) && boxes[i].intersects(boxes[j])) pairs.emplace_back(std::min(a, b), std::max(a, b));
}

}  // namespace

Pairs neighbours(const std::vector<Box>& boxes, const std::vector<bool>& movable) {
  Pairs pairs;
  constexpr int few = 8;  // a grid costs more than it saves
  const auto count = static_cast<int>(boxes.size());
  if (count <= few) {
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) add_if_near(boxes, movable, a, b, pairs);
    }
    return pairs;
  }
  const double cell = 2 * typical_extent(boxes);
  std::unordered_map<std::uint64_t, std::vector<int>> grid;
  std::vector<int> large;
  for (int b = 0; b < count; ++b) {
    const Box& box = boxes[static_cast<std::size_t>(b)];
    for (const int other : large) add_if_near(boxes, movable, b, other, pairs);
    if (extent(box) > 4 * cell) {
      for (int other = 0; other < b; ++other) {
        if (std::find(large.begin(), large.end(), other) == large.end()) add_if_near(boxes, movable, b, other, pairs);
      }
      large.push_back(b);
      continue;
    }
    const auto index = [cell](double x) { return static_cast<std::int64_t>(std::floor(x / cell)); };
    for (auto i = index(box.min().x()); i <= index(box.max().x()); ++i) {
      for (auto j = index(box.min().y()); j <= index(box.max().y()); ++j) {
        auto& occupants = grid[static_cast<std::uint64_t>(i) << 32U ^ (static_cast<std::uint64_t>(j) & 0xffffffffU)];
        for (const int other : occupants) add_if_near(boxes, movable, b, other, pairs);
        occupants.push_back(b);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace blockweir::solid
