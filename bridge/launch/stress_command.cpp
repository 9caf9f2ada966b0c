// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/engine_options.hpp"
#include "bridge/validate/stress.hpp"

namespace blockweir::launch {

Work stress_command(CLI::App& app) {
  const auto options = std::make_shared<study::StressOptions>();
  app.add_option("names", options->names,
                 "names of maps in cases/stress, or scene files with maps (default: all maps)");
  app.add_option("--out", options->out, "folder for tables and pictures (default: runs/stress)");
  app.add_flag("--short", options->brief, "only the first, the middle and the last value of each key");
  add_engine_options(app, options->engine);
  return [options] { return study::stress(*options); };
}

}  // namespace blockweir::launch
