// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir compare: the three contact formulations, or several fluids, on the same scenes, side by side.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::study {

struct CompareOptions {
  std::vector<std::filesystem::path> cases;  ///< empty: a few of the cases folder
  std::filesystem::path json;                ///< empty: none
  std::filesystem::path out;                 ///< keeps each run as a folder of its own; empty: none is kept
  std::vector<std::string> overrides;
  std::vector<std::string> fluids;  ///< models of [fluid] to compare; empty: contact formulations are compared
};

/// Prints a row for each scene, formulation and figure: error, largest penetration, condition number, solved systems,
/// steps, wall time. A run that failed has a row, too: why, and the command that repeats it. Returns 1 then; a figure
/// that is out of tolerance is a result here.
int compare(const CompareOptions& options);

/// The same for fluids: each scene with each model, its wall time, its figures, and for each block that moves the
/// largest force of the water along x and half of the force's range. A model is that of the scene, or of the first
/// variant that has it, or is set alone. What the scene has no answer for is held against the first model.
int compare_fluids(const CompareOptions& options);

}  // namespace blockweir::study
