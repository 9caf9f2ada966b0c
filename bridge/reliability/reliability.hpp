// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir reliability: the probability that a scene with uncertain numbers fails at a level of its reservoir.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/study/engine_options.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

struct ReliabilityOptions {
  std::filesystem::path scene;
  std::filesystem::path out{};   ///< folder for samples, pictures and the answer; empty: runs/CASE-reliability
  std::filesystem::path json{};  ///< further file for the answer; empty: none
  Settings overrides{};
  EngineOptions engine{};
};

/// Prints probability, reliability index, design point and Sobol's indices, and draws the fragility curve. Returns 0; 1
/// if samples or a method have no answer, 130 if it was stopped. Throws scene::SceneError, and std::invalid_argument
/// for an unsuitable scene or options.
int print_reliability(const ReliabilityOptions& options);

}  // namespace blockweir::study
