// SPDX-License-Identifier: GPL-3.0-or-later
// The water outside joints, from the panels of a load: the faces that it presses on, and its pressure near them.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::joints {

using scene::Point;

class OpenWater {
 public:
  struct Face {
    double s_from;
    double s_to;
    double pressure_from_pa;
    double pressure_to_pa;
  };

  /// The first `panels` of the load. `atmosphere_pa` is subtracted: it acts in joints, too.
  OpenWater(const std::vector<std::vector<Point>>& outlines, const wire::Load& load, std::size_t panels,
            double water_n_per_m3, double atmosphere_pa);

  /// Pressure of the nearest water on one of these blocks, converted to the elevation of p; none if there is none
  /// within `near_m`, or if p is above that water.
  [[nodiscard]] std::optional<double> pressure(const Point& p, const std::vector<int>& blocks, double near_m) const;
  /// Panels on an edge.
  [[nodiscard]] const std::vector<Face>& on(int block, int edge) const;
  [[nodiscard]] bool covers(int block, int edge, double s) const;

 private:
  const std::vector<std::vector<Point>>& outlines_;
  double water_n_per_m3_;
  std::map<std::pair<int, int>, std::vector<Face>> faces_;
};

}  // namespace blockweir::joints
