// SPDX-License-Identifier: GPL-3.0-or-later
// A scene under the loads and levels of the end of its run, without running it.
#pragma once

#include <optional>

#include "solid/capacity/still_water.hpp"
#include "solid/limit/twist.hpp"

namespace blockweir::solid {

struct Situation {
  const scene::Scene& scene;
  std::optional<StillWater> water;  ///< none if the scene has none
  double level_m;                   ///< of the reservoir; NaN without water

  /// The scene must outlive it. Throws as StillWater does.
  Situation(const scene::Scene& scene, const process::FluidMaker& make_fluid);

  /// Forces of weight and water on the blocks as drawn.
  [[nodiscard]] limit::Wrenches dead();
  StillWater* water_if_any() { return water ? &*water : nullptr; }
};

}  // namespace blockweir::solid
