// SPDX-License-Identifier: GPL-3.0-or-later
// What the settings of a bench are off by: found by an engine, whatever time a run takes.
#pragma once

#include <string>
#include <vector>

#include "bridge/engine/engine.hpp"
#include "bridge/validate/bench_case.hpp"

namespace blockweir::study {

struct BenchError {
  double error = 0;        ///< relative, of the scene's first figure or of its motion
  double energy_gain = 0;  ///< energy made, of what the run had
  std::string trouble;     ///< why there is none, else empty
};

struct BenchErrors {
  std::string figure;  ///< whose error it is
  bool of_motion = false;
  std::vector<BenchError> settings;  ///< as those of the case
};

/// Of all settings of all cases, each run once. Throws Interrupted, and std::runtime_error where a run with finer steps
/// fails.
std::vector<BenchErrors> errors_of(const std::vector<BenchCase>& cases, engine::Engine& engine);

}  // namespace blockweir::study
