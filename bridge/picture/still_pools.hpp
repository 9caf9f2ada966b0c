// SPDX-License-Identifier: GPL-3.0-or-later
// Where still water stands in a frame of a run.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/picture/view.hpp"

namespace blockweir::picture {

/// Outlines of the pools in view [m]: what lies under their levels and outside the blocks, as far as it reaches a face
/// on which the frame has pressure. Beyond the last wet point a pool stands on a level bed.
std::vector<std::vector<Eigen::Vector2d>> still_pools(const nlohmann::json& frame, const View& view);

}  // namespace blockweir::picture
