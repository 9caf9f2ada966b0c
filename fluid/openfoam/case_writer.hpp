// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a complete interFoam case from a scene: an OpenFOAM user can open it, change it and run it by hand.
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

/// Writes 0, constant and system and removes times and processor folders of a previous run; other files in the folder
/// are kept. Throws std::invalid_argument for a scene that cannot be meshed and std::runtime_error if a file cannot be
/// written.
void write_case(const scene::Scene& scene, const Grid& grid, const CaseOptions& options);

Surroundings surroundings(const scene::Scene& scene, const Grid& grid);

/// Prepares a case to continue from time `time_s`, with motion `first_window`: removes later times.
void prepare_resumption(const scene::Scene& scene, const Surroundings& around, const CaseOptions& options,
                        std::uint64_t first_window, double time_s);

/// system/decomposeParDict for the scene's processes.
std::string decompose_dictionary(const scene::Scene& scene);

/// controlDict's endTime: later than the end of the run, which the solid process decides.
double end_time_s(const scene::Scene& scene);

/// controlDict's deltaT for the first step; the coupling sets the others.
double first_step_s(const scene::Scene& scene);

}  // namespace blockweir::openfoam
