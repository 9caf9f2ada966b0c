// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "bridge/launch/commands.hpp"
#include "bridge/picture/profile.hpp"

namespace blockweir::launch {

Work profile_command(CLI::App& app) {
  const auto options = std::make_shared<picture::ProfileOptions>();
  app.add_option("run", options->run, "folder of a run")->required();
  app.add_flag("--svg", options->svg, "draw SVG instead of PNG");
  return [options] { return picture::profile(*options), 0; };
}

}  // namespace blockweir::launch
