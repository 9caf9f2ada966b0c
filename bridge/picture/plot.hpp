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
  bool animated = false;            ///< also all frames as animation.gif
  bool section = false;             ///< also the section with names of joints and loads
  std::vector<std::string> blocks;  ///< blocks named in legends; empty: the eight that move most
  std::filesystem::path data;       ///< CSV of measured points: time_s, then columns of history.csv; empty: none
};

/// Writes displacements, velocities, rotations, level, snapshots and picture (.png or .svg) into the run's folder and
/// prints their names. Throws std::invalid_argument if the folder contains no run, and for blocks or data that the run
/// does not have; std::runtime_error if gnuplot is missing.
void plot(const PlotOptions& options);

}  // namespace blockweir::picture
