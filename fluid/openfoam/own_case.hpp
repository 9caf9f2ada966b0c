// SPDX-License-Identifier: GPL-3.0-or-later
// A user's own interFoam case: copied as it is, and told of the blocks.
#pragma once

#include "fluid/openfoam/case_writer.hpp"

namespace blockweir::openfoam {

/// Copies the case `from` without its former results, adds the plugin's entries and constant/blockweir, and makes what
/// it lacks: the mesh by its blockMeshDict, the fields of time 0 from 0.orig with setAlphaField or setFields. Throws
/// std::invalid_argument for what is not an interFoam case and std::runtime_error when a file cannot be written or a
/// program of OpenFOAM's fails.
void adopt_case(const scene::Scene& scene, const std::filesystem::path& from, const CaseOptions& options);

/// Of a copy that adopt_case made.
Surroundings own_surroundings(const scene::Scene& scene);

}  // namespace blockweir::openfoam
