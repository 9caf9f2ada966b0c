// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the settings of a bench, computed by an engine, independent of the run times.
#pragma once

#include <string>
#include <vector>

#include "bridge/engine/engine.hpp"
#include "bridge/validate/bench_case.hpp"

namespace blockweir::study {

struct BenchError {
  double error = 0;        ///< relative, of the scene's first figure or of its motion
  double energy_gain = 0;  ///< energy produced, relative to the energy of the run
  std::string trouble;     ///< why there is no error; empty: there is one
};

struct BenchErrors {
  std::string figure;  ///< the quantity of the errors
  bool of_motion = false;
  std::vector<BenchError> settings;  ///< in the order of the case's settings
};

/// Errors of all settings of all cases; each runs once. Throws Interrupted, and std::runtime_error if a run with finer
/// steps fails.
std::vector<BenchErrors> errors_of(const std::vector<BenchCase>& cases, engine::Engine& engine);

}  // namespace blockweir::study
