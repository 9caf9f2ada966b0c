// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/picture/plot.hpp"

namespace blockweir::launch {

Work plot_command(CLI::App& app) {
  const auto options = std::make_shared<picture::PlotOptions>();
  app.add_option("run", options->run, "folder of a run")->required();
  app.add_flag("--svg", options->svg, "SVG instead of PNG");
  app.add_flag("--animate", options->animated, "all frames as animation.gif too");
  return [options] { return picture::plot(*options), 0; };
}

}  // namespace blockweir::launch
