// SPDX-License-Identifier: GPL-3.0-or-later
// How the scene shakes the ground below the water: by a record, or steadily as a pseudo-static earthquake has it.
#pragma once

#include "bridge/scene/scene.hpp"

namespace blockweir::reservoir {

using geometry::Point;

class Shaking {
 public:
  /// The scene must outlive it.
  explicit Shaking(const scene::Scene& scene) : scene_(scene) {}

  /// A pseudo-static earthquake: loads of all that can move, as by ground that accelerates the other way.
  [[nodiscard]] bool is_steady() const;
  [[nodiscard]] Point steady_acceleration() const;
  /// The mean over a window of what the scene states [m/s^2].
  [[nodiscard]] Point stated_acceleration(const scene::TimeSpan& window) const;
  /// Does the scene keep its frame on the ground, so that blocks are loaded in place of being carried?
  [[nodiscard]] bool is_in_frame_of_ground() const;

 private:
  const scene::Scene& scene_;
};

}  // namespace blockweir::reservoir
