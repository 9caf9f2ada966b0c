// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir cut: draws the blocks of a scene without running it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::picture {

struct CutOptions {
  std::filesystem::path scene;
  std::filesystem::path out{};  ///< .png or .svg
  std::vector<std::string> overrides;
};

/// Draws the blocks and prints their number and sizes. Throws scene::SceneError, std::invalid_argument for a file that
/// cannot be written, and std::runtime_error if gnuplot is missing.
void cut(const CutOptions& options);

}  // namespace blockweir::picture
