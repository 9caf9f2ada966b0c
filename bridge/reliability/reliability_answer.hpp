// SPDX-License-Identifier: GPL-3.0-or-later
// The reliability of a scene: samples, methods, and the differences between the ways to find a level.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/reliability/reliability.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::study {

struct FoundReliability {
  nlohmann::json answer;  ///< content of reliability.json
  std::string samples;    ///< CSV, one row for each sample
};

/// `read`: the scene of the options, with at least one [[random]]. `folder` exists; samples are stored in it, and none
/// is computed twice. Throws Interrupted, scene::SceneError, and std::invalid_argument for an unsuitable scene or
/// options.
FoundReliability find_reliability(const ReliabilityOptions& options, const scene::ReadScene& read,
                                  const std::filesystem::path& folder);

}  // namespace blockweir::study
