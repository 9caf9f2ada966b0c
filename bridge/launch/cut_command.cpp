// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/picture/cut.hpp"
#include "bridge/process/programs.hpp"

namespace blockweir::launch {

Work cut_command(CLI::App& app) {
  const auto options = std::make_shared<picture::CutOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--out", options->out, "picture, .png or .svg (default: CASE-cut.png)");
  app.add_option("--set", options->overrides, "set a key of the scene, as key=value");
  return [options] {
    // Named by the scene: the picture of another one stays.
    if (options->out.empty()) options->out = process::case_name(options->scene) + "-cut.png";
    return picture::cut(*options), 0;
  };
}

}  // namespace blockweir::launch
