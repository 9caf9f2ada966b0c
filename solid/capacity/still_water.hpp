// SPDX-License-Identifier: GPL-3.0-or-later
// Still water of a scene with the reservoir at any given level, whatever levels the scene states.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bridge/process/sides.hpp"
#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"
#include "solid/limit/level_range.hpp"

namespace blockweir::solid {

class StillWater {
 public:
  /// The tailwater is that of the run's end. Throws std::invalid_argument if the scene's fluid has no levels and is not
  /// still water, or if gravity is tilted.
  StillWater(const scene::Scene& scene, const process::FluidMaker& make);

  [[nodiscard]] const limit::LevelRange& range() const { return range_; }
  /// Pressures on the blocks at the positions of `motion`, valid until the next call.
  const wire::Load& at(double level_m, const wire::Motion& motion);
  /// Pressures on the blocks as drawn.
  const wire::Load& at(double level_m);
  /// Warnings of all calls so far.
  [[nodiscard]] std::vector<std::string> warnings() const { return fluid_->report().warnings; }

 private:
  limit::LevelRange range_;
  scene::Scene scene_;  ///< its time stands for the level above the empty reservoir
  std::unique_ptr<schedule::FluidSide> fluid_;
  wire::Load load_;
};

}  // namespace blockweir::solid
