// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/scene_file_check.hpp"
#include "bridge/launch/variant_option.hpp"
#include "bridge/study/safety.hpp"

namespace blockweir::launch {

Work safety_command(CLI::App& app) {
  const auto options = std::make_shared<study::SafetyOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--out", options->out,
                 "folder for the answers, one within it for each load case (default: runs/CASE-safety)");
  app.add_flag("--quiet", options->no_progress, "show no progress");
  app.add_option("--json", options->json, "also write the answer to this file, as JSON");
  add_variant_option(app, options->variant);
  app.add_option("--set", options->overrides, "set a key of the scene, as key=value");
  return [options] {
    require_sound_file(options->scene, options->overrides);
    return study::print_safety(*options);
  };
}

}  // namespace blockweir::launch
