// SPDX-License-Identifier: GPL-3.0-or-later
// What limit analysis says of a run that has ended: how far it is from failing, or by how much it fails.
#pragma once

#include "bridge/process/run.hpp"

namespace blockweir::process {

/// Adds "limit_analysis" to the run's summary, in memory and in its folder, with a "text" to tell. Nothing where the
/// answer would be another question's: of a run that was stopped, in water that moves, on ground that shakes, of blocks
/// that are drawn on the move.
void add_limit_margin(RunResult& result);

}  // namespace blockweir::process
