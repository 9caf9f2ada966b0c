// SPDX-License-Identifier: GPL-3.0-or-later
// Prepares a user's own interFoam case: a copy with the entries that connect it to the blocks.
#pragma once

#include "fluid/openfoam/case_writer.hpp"

namespace blockweir::openfoam {

/// Copies the case `from` without previous results, adds the plugin's entries and constant/blockweir, and makes missing
/// parts: the mesh by its blockMeshDict, the fields of time 0 from 0.orig with setAlphaField or setFields. Throws
/// std::invalid_argument if it is not an interFoam case, and std::runtime_error if a file cannot be written or a
/// program of OpenFOAM fails.
void adopt_case(const scene::Scene& scene, const std::filesystem::path& from, const CaseOptions& options);

/// For a copy made by adopt_case.
Surroundings own_surroundings(const scene::Scene& scene);

}  // namespace blockweir::openfoam
