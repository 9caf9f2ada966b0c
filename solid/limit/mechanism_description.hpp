// SPDX-License-Identifier: GPL-3.0-or-later
// Describes a mechanism of limit analysis: which blocks move, on which joints, and how.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "solid/limit/limit_analysis.hpp"

namespace blockweir::solid::limit {

struct MechanismDescription {
  std::string mode;                 ///< "sliding", "overturning", "sliding and overturning"
  std::vector<std::size_t> moving;  ///< blocks, indices into Scene::blocks
  std::vector<std::string> joints;  ///< joints that open or slip; first the one that starts farthest upstream
  std::optional<Point> mouth_m;     ///< where that one starts
  std::string text;                 ///< the description as a sentence
  bool dilates = false;             ///< some joint that slips opens all along, by the associated rule
};

MechanismDescription words_of(const LimitAnalysis& structure, const Twists& mechanism);

}  // namespace blockweir::solid::limit
