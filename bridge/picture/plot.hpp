// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir plot: figures of a run, drawn by gnuplot without a display, from history.csv, frames.jsonl (keys: see
// solid/output/frame_log.hpp) and summary.json.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::picture {

struct PlotOptions {
  std::filesystem::path run;
  bool svg = false;
  bool animated = false;            ///< all frames as animation.gif too
  bool section = false;             ///< the section with joints' names and loads, too
  std::vector<std::string> blocks;  ///< that legends name; empty: the eight that move most
  std::filesystem::path data;       ///< CSV of measured points: time_s, then columns of history.csv; empty: none
};

/// Writes displacements, velocities, rotations, level, snapshots and picture (.png or .svg) into the run's folder and
/// names them on standard output. Throws std::invalid_argument when the folder holds no run, and for blocks or data
/// that the run does not know; std::runtime_error when gnuplot is missing.
void plot(const PlotOptions& options);

}  // namespace blockweir::picture
