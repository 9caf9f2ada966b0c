// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one side to the end of the run. On an exception of its own the partner is told before it goes on.
#pragma once

#include "bridge/schedule/exchange.hpp"

namespace blockweir::schedule {

struct Exchanges {
  long said = 0;
  long skipped = 0;  ///< the answer of the one before still held
};

/// By the scene's schedule. `fluid` is null where the scene has no water; `first` is the motion that the run starts
/// or is resumed with.
Exchanges run_solid(FluidLine* fluid, const scene::Scene& scene, checkpoint::Checkpoints& checkpoints,
                    std::uint64_t first, SolidSide& solid);

/// As a process of its own, until the solid ends the run. `first` as in FluidTurn.
FluidReport run_fluid(channel::Channel& channel, checkpoint::Checkpoints& checkpoints, std::uint64_t first,
                      FluidSide& fluid);

}  // namespace blockweir::schedule
