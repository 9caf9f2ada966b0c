// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir plot: figures of a run, drawn by gnuplot without a display, from history.csv, frames.jsonl (keys: see
// solid/output/frame_log.hpp) and summary.json.
#pragma once

#include <filesystem>

namespace blockweir::picture {

struct PlotOptions {
  std::filesystem::path run;
  bool svg = false;
  bool animated = false;  ///< all frames as animation.gif too
};

/// Writes displacements, velocities, rotations, level, snapshots and picture (.png or .svg) into the run's folder and
/// names them on standard output. Throws std::invalid_argument when the folder holds no
/// run, std::runtime_error when gnuplot is missing.
void plot(const PlotOptions& options);

}  // namespace blockweir::picture
