// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir compare: compares the three contact formulations, or several fluids, on the same scenes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::study {

struct CompareOptions {
  std::vector<std::filesystem::path> cases;  ///< empty: a selection of the cases folder
  std::filesystem::path json;                ///< empty: none
  std::filesystem::path out;                 ///< keeps each run as a folder; empty: none is kept
  std::vector<std::string> overrides;
  std::vector<std::string> fluids;  ///< models of [fluid] to compare; empty: compares contact formulations
};

/// Prints a row for each scene, formulation and figure: error, largest penetration, condition number, solved systems,
/// steps, wall time. A failed run has a row with its error and the command that repeats it; the return value is then 1.
/// A figure out of tolerance is a result here.
int compare(const CompareOptions& options);

/// The same for fluids: for each scene and model the wall time, the figures, and for each moving block the largest
/// horizontal water force and half of the force's range. A model is the scene's own, or that of the first variant with
/// it, or is set with nothing else changed. Figures without a stated value are compared with the first model.
int compare_fluids(const CompareOptions& options);

}  // namespace blockweir::study
