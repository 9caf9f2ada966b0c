// SPDX-License-Identifier: GPL-3.0-or-later
// Still water on a scene with the reservoir at any level, whatever filling the scene states.
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
  /// The tailwater is that of the run's end. Throws std::invalid_argument where the scene's fluid is no still water and
  /// has no levels either, or gravity is tilted.
  StillWater(const scene::Scene& scene, const process::FluidMaker& make);

  [[nodiscard]] const limit::LevelRange& range() const { return range_; }
  /// On blocks where `motion` says, valid until the next call.
  const wire::Load& at(double level_m, const wire::Motion& motion);
  /// On blocks where they are drawn.
  const wire::Load& at(double level_m);
  /// Of what has been asked so far.
  [[nodiscard]] std::vector<std::string> warnings() const { return fluid_->report().warnings; }

 private:
  limit::LevelRange range_;
  scene::Scene scene_;  ///< whose time is the level above the empty reservoir's
  std::unique_ptr<schedule::FluidSide> fluid_;
  wire::Load load_;
};

}  // namespace blockweir::solid
