// SPDX-License-Identifier: GPL-3.0-or-later
// Where still water stands in a frame of a run.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/picture/view.hpp"

namespace blockweir::picture {

/// Outlines of the pools in view [m]: what lies under their levels and outside the blocks, as far as it reaches a face
/// on which the frame has pressure. Beyond the last wet point a pool stands on a level bed. None stands higher than the
/// highest block, which alone could hold it, unless all blocks that move have left the view.
std::vector<std::vector<Eigen::Vector2d>> still_pools(const nlohmann::json& frame, const View& view);

/// Is a level above all blocks? The run goes on with its pressures, but still water would not stand so.
bool above_all(const nlohmann::json& frame);

}  // namespace blockweir::picture
