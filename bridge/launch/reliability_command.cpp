// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/engine_options.hpp"
#include "bridge/launch/scene_file_check.hpp"
#include "bridge/reliability/reliability.hpp"

namespace blockweir::launch {

Work reliability_command(CLI::App& app) {
  const auto options = std::make_shared<study::ReliabilityOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--out", options->out, "folder for samples and pictures (default: runs/CASE-reliability)");
  app.add_option("--json", options->json, "also write the answer to this file, as JSON");
  app.add_option("--set", options->overrides, "set a key of the scene, as key=value");
  add_engine_options(app, options->engine);
  return [options] {
    require_sound_file(options->scene, options->overrides);
    return study::print_reliability(*options);
  };
}

}  // namespace blockweir::launch
