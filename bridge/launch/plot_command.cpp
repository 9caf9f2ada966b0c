// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/picture/plot.hpp"

namespace blockweir::launch {

Work plot_command(CLI::App& app) {
  const auto options = std::make_shared<picture::PlotOptions>();
  app.add_option("run", options->run, "folder of a run")->required();
  app.add_flag("--svg", options->svg, "draw SVG instead of PNG");
  app.add_flag("--animate", options->animated, "also draw all stored moments, as animation.gif");
  app.add_flag("--section", options->section, "also draw the section, with the names of joints and the loads");
  app.add_option("--blocks", options->blocks, "blocks that the legends name (default: the eight that move most)")
      ->delimiter(',');
  app.add_option("--data", options->data,
                 "CSV file of measurements to draw: time_s, then columns named as in history.csv");
  return [options] { return picture::plot(*options), 0; };
}

}  // namespace blockweir::launch
