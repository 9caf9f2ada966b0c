// SPDX-License-Identifier: GPL-3.0-or-later
// Command-line options of all programs that contain the solid.
#pragma once

#include "bridge/channel/line_options.hpp"
#include "bridge/process/sides.hpp"

namespace blockweir::process {

inline void add_solid_options(CLI::App& app, SolidProcess& process) {
  app.add_option("scene", process.scene, "scene file or case folder")->required();
  app.add_option("--out", process.folder, "folder for the results")->required();
  app.add_option("--set", process.overrides, "set a key of the scene, as key=value; the same for both processes");
  app.add_option("--resume", process.resume,
                 "continue from the checkpoint of this number in --out; the same for both processes");
  app.add_option("--progress-fd", process.progress_fd, "file descriptor for progress lines");
}

}  // namespace blockweir::process
