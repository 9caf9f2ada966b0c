// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/scene_file_check.hpp"
#include "bridge/launch/variant_option.hpp"
#include "bridge/launch/version.hpp"
#include "bridge/process/previous_run.hpp"
#include "bridge/report/report.hpp"

namespace blockweir::launch {

Work report_command(CLI::App& app) {
  const auto options = std::make_shared<study::ReportOptions>();
  app.add_option("source", options->source, "folder of a run; or a scene file or case folder, which is run first")
      ->required();
  app.add_option("--out", options->out, "HTML file (default: report.html in the run's folder)");
  app.add_option("--reliability", options->reliability,
                 "folder of \"blockweir reliability\" for this scene (default: it is asked for, by limit analysis)");
  app.add_option("--run", options->run,
                 "folder for the run of a scene (default: that of \"blockweir run\"; with --out, where \"runs\" cannot "
                 "be written, a temporary one)");
  add_variant_option(app, options->variant);
  app.add_option("--set", options->overrides, "set a key of the scene, as key=value");
  return [options] {
    if (!process::is_run(options->source)) require_sound_file(options->source, options->overrides);
    options->program = version();
    return study::write_report(*options);
  };
}

}  // namespace blockweir::launch
