// SPDX-License-Identifier: GPL-3.0-or-later
// A whole interFoam case from a scene: an OpenFOAM user can open it, change it and run it by hand.
#pragma once

#include <filesystem>
#include <string>

#include "bridge/scene/scene.hpp"
#include "fluid/openfoam/grid.hpp"
#include "fluid/openfoam/interface_dictionary.hpp"

namespace blockweir::openfoam {

struct CaseOptions {
  std::filesystem::path folder;
  std::filesystem::path plugin;  ///< shared library
  std::string endpoint;          ///< of the solid process
};

/// Writes 0, constant and system and removes the times and parts of a former run; what else stands in the folder is
/// left alone. Throws std::invalid_argument for a scene that cannot be meshed and std::runtime_error when a file cannot
/// be written.
void write_case(const scene::Scene& scene, const Grid& grid, const CaseOptions& options);

Surroundings surroundings(const scene::Scene& scene, const Grid& grid);

/// Makes a case that has run go on from time `time_s`, with motion `first_window`: later times are removed.
void prepare_resumption(const scene::Scene& scene, const Surroundings& around, const CaseOptions& options,
                        std::uint64_t first_window, double time_s);

/// system/decomposeParDict for the scene's processes.
std::string decompose_dictionary(const scene::Scene& scene);

/// controlDict's endTime: later than the solid process ends the run.
double end_time_s(const scene::Scene& scene);

/// controlDict's deltaT: of the first step; the coupling sets the others.
double first_step_s(const scene::Scene& scene);

}  // namespace blockweir::openfoam
