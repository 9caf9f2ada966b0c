// SPDX-License-Identifier: GPL-3.0-or-later
// Runs OpenFOAM's programs one after the other, on a case of ours or of the user.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/channel/channel.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::openfoam {

struct RunOptions {
  std::filesystem::path folder;
  channel::Options line{.side = channel::Side::connects};  ///< interFoam's plugin opens it
  bool case_only = false;
  std::uint64_t resume = 0;              ///< number of the checkpoint to resume from; 0: from the start
  std::filesystem::path scene_folder{};  ///< where the scene's paths start; empty: beside its file
  std::filesystem::path report{};        ///< file for times and checks of the water (JSON); empty: none
};

/// Writes or copies the case, makes its mesh and runs interFoam to its end; their output goes to log.PROGRAM in the
/// case's folder. Throws std::runtime_error with one line if OpenFOAM is missing or one of its programs fails.
int run_case(const scene::Scene& scene, const RunOptions& options);

}  // namespace blockweir::openfoam
