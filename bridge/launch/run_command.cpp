// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/run_and_report.hpp"
#include "bridge/launch/scene_file_check.hpp"
#include "bridge/launch/variant_option.hpp"

namespace blockweir::launch {

Work run_command(CLI::App& app) {
  const auto options = std::make_shared<process::RunOptions>();
  options->margin = true;
  options->keeps_others = true;
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option(
      "--out", options->out,
      "folder for the results; no run of another scene in it is overwritten, nor one to resume (default: runs/CASE, or "
      "runs/CASE-2, -3, ... where that holds an earlier run)");
  add_variant_option(app, options->variant);
  app.add_option("--set", options->overrides, "set a key of the scene, e.g. analysis.step_s=0.001");
  app.add_flag("--inproc", options->inproc,
               "compute still water or a reservoir in the solid's process; the results are the same");
  app.add_flag("--strict", options->strict, "treat warnings as errors; a scene that has any is not run");
  app.add_flag("--trace", options->trace, "record when each side computes and waits, for \"blockweir trace\"");
  app.add_flag("--quiet", options->quiet, "show no progress");
  return [options] {
    require_sound_file(options->scene, options->overrides);
    return run_and_report([&] { return process::run(*options); });
  };
}

}  // namespace blockweir::launch
