// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/told_run.hpp"

namespace blockweir::launch {

Work resume_command(CLI::App& app) {
  const auto options = std::make_shared<process::ResumeOptions>();
  options->margin = true;
  app.add_option("run", options->folder, "folder of the run")->required();
  app.add_flag("--inproc", options->inproc, "compute still water or a reservoir in the solid's process");
  app.add_flag("--quiet", options->quiet, "show no progress");
  return [options] { return told([&] { return process::resume(*options); }); };
}

}  // namespace blockweir::launch
