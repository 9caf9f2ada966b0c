// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one side to the end of the run. On an exception of its own the partner is told before it goes on.
#pragma once

#include <optional>

#include "bridge/schedule/exchange.hpp"

namespace blockweir::schedule {

/// Seconds that the exchange cost this side.
struct ExchangeTime {
  double wait_s = 0;  ///< for the partner
  double pack_s = 0;  ///< into bytes and back
  double wire_s = 0;  ///< of handing them to ZeroMQ
};

/// By the scene's schedule. `channel` is null where the scene has no water; `first` is the motion that the run starts
/// or is resumed with.
ExchangeTime run_solid(channel::Channel* channel, const scene::Scene& scene, checkpoint::Checkpoints& checkpoints,
                       std::uint64_t first, SolidSide& solid);

/// Where a run is resumed and there is no checkpoint of a fluid that needs none, it begins at motion `first` anew.
ExchangeTime run_fluid(channel::Channel& channel, checkpoint::Checkpoints& checkpoints, std::uint64_t first,
                       FluidSide& fluid);

}  // namespace blockweir::schedule
