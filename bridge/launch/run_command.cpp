// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/told_run.hpp"

namespace blockweir::launch {

Work run_command(CLI::App& app) {
  const auto options = std::make_shared<process::RunOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--out", options->out, "folder for the results (default: runs/CASE)");
  app.add_option("--variant", options->variant, "name of one of the scene's variants");
  app.add_option("--set", options->overrides, "key=value over the scene's own, e.g. analysis.step_s=0.001");
  app.add_flag("--inproc", options->inproc, "still water within the solid's process: the same results, sooner");
  app.add_flag("--strict", options->strict, "warnings are errors: such a scene is not run");
  app.add_flag("--quiet", options->quiet, "no progress");
  return [options] { return told([&] { return process::run(*options); }); };
}

}  // namespace blockweir::launch
