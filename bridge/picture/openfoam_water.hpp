// SPDX-License-Identifier: GPL-3.0-or-later
// The water of an OpenFOAM run, read from interFoam's results for pictures.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/geometry/point.hpp"
#include "bridge/picture/view.hpp"

namespace blockweir::picture {

/// Water in one cell: a box [m], its volume fraction of water, and its speed [m/s].
struct WaterBox {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  double share = 1;
  double speed = 0;
};

/// Results of the case in `run`/openfoam, by time.
class OpenFoamWater {
 public:
  /// Empty if the run has none.
  explicit OpenFoamWater(const std::filesystem::path& run);

  [[nodiscard]] bool empty() const { return times_.empty(); }

  /// At the stored time nearest to time_s; unreadable files are left out.
  [[nodiscard]] std::vector<WaterBox> boxes(double time_s) const;

 private:
  struct StoredTime {
    double time_s = 0;
    std::filesystem::path folder;
  };
  std::vector<StoredTime> times_;
  std::vector<double> x_;  ///< column lines [m]
  std::vector<double> y_;  ///< row lines [m]
};

/// The water of time 0 where the scene draws all of it; empty where pools stand: they are at the structure.
std::vector<std::vector<geometry::Point>> all_drawn_water(const std::filesystem::path& run,
                                                          const nlohmann::json& first_frame);

/// The view with the drawn water, or as much of it as leaves the structure large enough to be seen.
View with_drawn_water(View view, const std::vector<std::vector<geometry::Point>>& outlines);

}  // namespace blockweir::picture
