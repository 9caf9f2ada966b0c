// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one side to the end of the run. If it throws, the other side is notified before the exception continues.
#pragma once

#include "bridge/schedule/exchange.hpp"

namespace blockweir::schedule {

struct Exchanges {
  long said = 0;
  long skipped = 0;  ///< windows in which the last load still held
};

/// Runs the solid by the scene's schedule. `fluid` is null if the scene has no water; `first` is the number of the
/// first motion, above 0 in a resumed run.
Exchanges run_solid(FluidLine* fluid, const scene::Scene& scene, checkpoint::Checkpoints& checkpoints,
                    std::uint64_t first, SolidSide& solid);

/// Runs a fluid in its own process until the solid ends the run. `first` as in FluidTurn.
FluidReport run_fluid(channel::Channel& channel, checkpoint::Checkpoints& checkpoints, std::uint64_t first,
                      FluidSide& fluid);

}  // namespace blockweir::schedule
