// SPDX-License-Identifier: GPL-3.0-or-later
// The two sides as processes, from the command line to the end of the run. solid and fluid/hydrostatic define them; a
// program contains one of them, or, in blockweir-inproc, both.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bridge/channel/channel.hpp"
#include "bridge/scene/scene.hpp"
#include "bridge/schedule/sides.hpp"

namespace blockweir::process {

using FluidMaker =
    std::function<std::unique_ptr<schedule::FluidSide>(const scene::Scene& scene, const std::filesystem::path& folder)>;

struct SolidProcess {
  std::string scene{};   ///< file or case folder
  std::string folder{};  ///< for the results
  channel::Options line{.side = channel::Side::listens};
  std::vector<std::string> overrides{};
  int progress_fd = -1;      ///< descriptor for progress lines; -1: readable text on standard error
  std::uint64_t resume = 0;  ///< number of the checkpoint to resume from; 0: from the start
  FluidMaker make_fluid{};   ///< makes a fluid within this process; empty: the fluid is another process
};

/// Throws what the run throws; summary.json then has the reason. Returns the report of a fluid within this process.
schedule::FluidReport run_process(SolidProcess process);

}  // namespace blockweir::process

namespace blockweir::hydrostatic {

/// Still water in the two pools of a scene; with [output] reservoir it also writes its VTK files to `folder`.
std::unique_ptr<schedule::FluidSide> make(const scene::Scene& scene, const std::filesystem::path& folder);

}  // namespace blockweir::hydrostatic

namespace blockweir::reservoir {

/// Water that responds to accelerations.
std::unique_ptr<schedule::FluidSide> make(const scene::Scene& scene, const std::filesystem::path& folder);

}  // namespace blockweir::reservoir
