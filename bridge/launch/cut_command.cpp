// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/picture/cut.hpp"

namespace blockweir::launch {

Work cut_command(CLI::App& app) {
  const auto options = std::make_shared<picture::CutOptions>();
  app.add_option("scene", options->scene, "scene file or case folder")->required();
  app.add_option("--out", options->out, "picture, .png or .svg (default: cut.png)");
  app.add_option("--set", options->overrides, "set a key of the scene, as key=value");
  return [options] { return picture::cut(*options), 0; };
}

}  // namespace blockweir::launch
