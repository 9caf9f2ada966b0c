// SPDX-License-Identifier: GPL-3.0-or-later
// The regions of still water in a frame of a run.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/picture/view.hpp"

namespace blockweir::picture {

/// Outlines of the pools in view [m]: the regions below their levels and outside the blocks, as far as they touch a
/// face on which the frame has pressure. Beyond the last wet point a pool has a level bed. No pool is drawn higher than
/// the highest block, which alone could retain it, unless all moving blocks have left the view.
std::vector<std::vector<Eigen::Vector2d>> still_pools(const nlohmann::json& frame, const View& view);

/// Whether a level is above all blocks. The run continues, but still water cannot stand like that.
bool above_all(const nlohmann::json& frame);

}  // namespace blockweir::picture
