// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir reliability: how likely a scene fails at a level of its reservoir, where some of its numbers are uncertain.
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
  std::filesystem::path json{};  ///< file for the answer, too; empty: none
  Settings overrides{};
  EngineOptions engine{};
};

/// Tells probability, reliability index, design point and Sobol's indices, and draws the fragility curve. Returns 0; 1
/// where samples or a method have no answer, and 130 where it was stopped. Throws scene::SceneError, and
/// std::invalid_argument for a scene or options that will not do.
int tell_reliability(const ReliabilityOptions& options);

}  // namespace blockweir::study
