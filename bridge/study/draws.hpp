// SPDX-License-Identifier: GPL-3.0-or-later
// The values of the keys in each run of a sample.
#pragma once

#include <filesystem>
#include <vector>

#include "bridge/scene/open_study.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// One list of settings for each run, drawn by blockweir-probability or read from a file. The same seed draws the same
/// values, and more runs only append to them. Throws scene::SceneError at the study's line in `scene` for a file that
/// cannot be read or lacks a column.
[[nodiscard]] std::vector<Settings> drawn_settings(const scene::OpenStudy& study, const std::filesystem::path& scene);

}  // namespace blockweir::study
