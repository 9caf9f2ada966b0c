// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/launch/engine_options.hpp"
#include "bridge/launch/scene_file_check.hpp"
#include "bridge/validate/validate.hpp"

namespace blockweir::launch {

Work validate_command(CLI::App& app) {
  const auto options = std::make_shared<study::ValidateOptions>();
  app.add_option("cases", options->cases, "case folders (default: all)");
  app.add_option("--json", options->json, "also write the table to this file, as JSON");
  app.add_option("--set", options->overrides, "set a key in each scene, as key=value");
  app.add_flag("--sweep", options->sweep, "repeat each with penalties 5e6, 1e9, 1e12 and steps 1e-2, 1e-3 s");
  app.add_flag("--short", options->brief, "of maps only the first, the middle and the last value of each key");
  add_engine_options(app, options->engine);
  return [options] {
    for (const auto& one : options->cases) require_sound_file(one, options->overrides);
    return study::validate(*options);
  };
}

}  // namespace blockweir::launch
