// SPDX-License-Identifier: GPL-3.0-or-later
// A whole interFoam case from a scene: an OpenFOAM user can open it, change it and run it by hand.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/scene/scene.hpp"
#include "fluid/openfoam/grid.hpp"

namespace blockweir::openfoam {

struct CaseOptions {
  std::filesystem::path folder;
  std::filesystem::path plugin;  ///< shared library
  std::string endpoint;          ///< of the solid process
};

/// Writes 0, constant and system and removes the times and parts of a former run; what else stands in the folder is
/// left alone. Throws std::invalid_argument for a
/// scene that cannot be meshed and std::runtime_error when a file cannot be written.
/// Makes a case that has run go on from time `time_s`, with motion `first_window`: later times are removed.
void prepare_resumption(const scene::Scene& scene, const Grid& grid, const CaseOptions& options,
                        std::uint64_t first_window, double time_s);

void write_case(const scene::Scene& scene, const Grid& grid, const CaseOptions& options);

}  // namespace blockweir::openfoam
