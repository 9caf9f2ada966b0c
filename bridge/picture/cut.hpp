// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir cut: a scene's blocks, drawn before anything runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::picture {

struct CutOptions {
  std::filesystem::path scene;
  std::filesystem::path out = "cut.png";  ///< .png or .svg
  std::vector<std::string> overrides;
};

/// Draws the blocks and says how many there are, of what sizes. Throws scene::SceneError, std::invalid_argument for a
/// file that cannot be written, and std::runtime_error when gnuplot is missing.
void cut(const CutOptions& options);

}  // namespace blockweir::picture
