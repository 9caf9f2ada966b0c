// SPDX-License-Identifier: GPL-3.0-or-later
// The space around a structure. A gap inside, from which no way wide enough leads out, is not part of it.
#pragma once

#include <vector>

#include "fluid/joints/polygon_offset.hpp"

namespace blockweir::joints {

class OpenSpace {
 public:
  /// Ways narrower than `open_m` between the blocks' outlines do not count: for that the blocks grow by half of it.
  OpenSpace(const std::vector<std::vector<Point>>& outlines, double open_m);

  /// Whether it comes that near to p.
  [[nodiscard]] bool reaches(const Point& p, double near_m) const;

 private:
  std::vector<Ring> shores_;  ///< outlines of the grown blocks together, as seen from outside
};

}  // namespace blockweir::joints
