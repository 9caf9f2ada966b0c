// SPDX-License-Identifier: GPL-3.0-or-later
// A mechanism of limit analysis in words: which blocks move, on which joints, and how.
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
  std::vector<std::string> joints;  ///< that they leave, the one that begins farthest upstream first
  std::optional<Point> mouth_m;     ///< where that begins
  std::string text;                 ///< a sentence
};

MechanismDescription words_of(const LimitAnalysis& structure, const Twists& mechanism);

}  // namespace blockweir::solid::limit
