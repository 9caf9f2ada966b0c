// SPDX-License-Identifier: GPL-3.0-or-later
// Figure of the ground acceleration and its response spectrum.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/picture/draw.hpp"

namespace blockweir::picture {

/// The picture `spectrum`; none if the ground does not move. `ending` chooses PNG or SVG.
std::vector<Picture> spectrum_picture(const std::filesystem::path& run, const std::string& ending);

}  // namespace blockweir::picture
