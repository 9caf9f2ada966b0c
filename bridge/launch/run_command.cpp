// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/process/run.hpp"
#include "bridge/process/supervisor.hpp"

namespace blockweir::launch {
namespace {

int tell(const process::RunResult& result) {
  if (!result.trouble.empty()) fmt::print(stderr, "blockweir: {}\n", process::trouble_text(result));
  fmt::print("{}", process::report(result));
  return result.exit_code;
}

/// What has ended by itself was not stopped: until the program's end a signal comes too late.
void stop_no_more() {
  static const process::StopsLater until_it_is_reported;
}

}  // namespace

Work run_command(CLI::App& app) {
  const auto options = std::make_shared<process::RunOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--out", options->out, "folder for the results (default: runs/CASE)");
  app.add_option("--variant", options->variant, "name of one of the scene's variants");
  app.add_option("--set", options->overrides, "key=value over the scene's own, e.g. analysis.step_s=0.001");
  app.add_flag("--inproc", options->inproc, "still water within the solid's process: the same results, sooner");
  app.add_flag("--strict", options->strict, "warnings are errors: such a scene is not run");
  app.add_flag("--quiet", options->quiet, "no progress");
  return [options] { return stop_no_more(), tell(process::run(*options)); };
}

Work resume_command(CLI::App& app) {
  const auto options = std::make_shared<process::ResumeOptions>();
  app.add_option("run", options->folder, "folder of the run")->required();
  app.add_flag("--inproc", options->inproc, "still water within the solid's process");
  app.add_flag("--quiet", options->quiet, "no progress");
  return [options] { return stop_no_more(), tell(process::resume(*options)); };
}

}  // namespace blockweir::launch
