// SPDX-License-Identifier: GPL-3.0-or-later
// The sides as processes, from the command line to the end of the run. solid and fluid/hydrostatic define them; a
// program holds one of them, or, blockweir-inproc, both.
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
  int progress_fd = -1;      ///< where progress lines go; -1: text for people on standard error
  std::uint64_t resume = 0;  ///< number of the checkpoint to go on from; 0: from the start
  FluidMaker make_fluid{};   ///< makes the fluid that stays in this process; none: it comes over the line
};

/// Throws what the run throws; summary.json then says why it stopped. Returns the report of a fluid in this process.
schedule::FluidReport run_process(SolidProcess process);

}  // namespace blockweir::process

namespace blockweir::hydrostatic {

/// Still water in the two pools of a scene; with [output] reservoir it also writes its pictures to `folder`.
std::unique_ptr<schedule::FluidSide> make(const scene::Scene& scene, const std::filesystem::path& folder);

}  // namespace blockweir::hydrostatic

namespace blockweir::reservoir {

/// Water that answers accelerations.
std::unique_ptr<schedule::FluidSide> make(const scene::Scene& scene, const std::filesystem::path& folder);

}  // namespace blockweir::reservoir
