// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/engine_options.hpp"
#include "bridge/validate/bench.hpp"

namespace blockweir::launch {

Work bench_command(CLI::App& app) {
  const auto options = std::make_shared<study::BenchOptions>();
  app.add_option("cases", options->cases, "case folders (default: all that have a [[bench]])");
  app.add_option("--out", options->out, "folder for the table and the pictures (default: runs/bench)");
  app.add_flag("--short", options->brief, "only two settings of each curve, each timed once");
  app.add_flag("--untimed", options->untimed, "errors alone: no run is timed");
  app.add_option("--set", options->overrides, "set a key in each scene, as key=value");
  add_engine_options(app, options->engine);
  return [options] { return study::bench(*options); };
}

}  // namespace blockweir::launch
