// SPDX-License-Identifier: GPL-3.0-or-later
// The region of silt in front of a dam in a frame of a run.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "bridge/picture/view.hpp"

namespace blockweir::picture {

/// Level of [silt] in a scene file [m]; none without silt, or without such a file.
[[nodiscard]] std::optional<double> silt_level_m(const std::filesystem::path& file);

/// Outlines in view [m]: the region below the silt's level, upstream of the crest and outside the blocks, as far as it
/// touches a face on which the frame has pressure.
[[nodiscard]] std::vector<std::vector<Eigen::Vector2d>> silt_bodies(const nlohmann::json& frame, double level_m,
                                                                    const View& view);

}  // namespace blockweir::picture
