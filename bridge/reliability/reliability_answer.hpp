// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of the reliability of a scene: samples, methods, and what the ways to find a level differ by.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "bridge/reliability/reliability.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::study {

struct FoundReliability {
  nlohmann::json answer;  ///< as reliability.json has it
  std::string samples;    ///< CSV, a row a sample
};

/// `read`: the scene of the options, with a [[random]] at least. `folder` is there; samples are kept in it, and none is
/// made twice. Throws Interrupted, scene::SceneError, and std::invalid_argument for a scene or options that will not
/// do.
FoundReliability find_reliability(const ReliabilityOptions& options, const scene::ReadScene& read,
                                  const std::filesystem::path& folder);

}  // namespace blockweir::study
