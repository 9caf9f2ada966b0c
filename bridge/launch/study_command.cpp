// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/engine_options.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::launch {

Work study_command(CLI::App& app) {
  const auto options = std::make_shared<study::StudyOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--name", options->name, "one of the studies (default: all)");
  app.add_option("--out", options->out, "folder for tables and figures ([[study]]: runs/CASE-studies by default)");
  add_engine_options(app, options->engine);
  app.add_option("--set", options->overrides, "set a key of the scene, as key=value");
  return [options] { return study::perform_all(*options); };
}

}  // namespace blockweir::launch
