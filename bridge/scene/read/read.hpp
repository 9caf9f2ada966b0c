// SPDX-License-Identifier: GPL-3.0-or-later
// From a TOML file to a Scene. Every problem of the file is collected before it is reported.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/scene/diagnostic.hpp"
#include "bridge/scene/load_case.hpp"
#include "bridge/scene/open_study.hpp"
#include "bridge/scene/randomness.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

struct ReadScene {
  Scene scene;
  std::vector<LoadCase> load_cases;
  std::vector<OpenStudy> open_studies;
  Randomness randomness;
  std::vector<Diagnostic> notes;     ///< what was mended on the way
  std::vector<Diagnostic> warnings;  ///< what has no effect, or an unusual magnitude; their messages are the scene's
};

/// Throws SceneError with the warnings as errors, if there are any: --strict.
void refuse_warnings(const std::vector<Diagnostic>& warnings);

/// The file that `path` means: a file, or a case's folder (which then holds scene.toml).
std::filesystem::path scene_file(const std::filesystem::path& path);

/// Reads and checks a scene. `path` is a file or a case's folder (which then holds scene.toml).
/// `overrides` are "dotted.key=value" in TOML syntax, as `--set` gives them.
/// Throws SceneError with everything that is wrong at once.
ReadScene read(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The scene with what its [[variant]] `name` sets, and `overrides` over that. An empty name is the scene itself.
/// Throws SceneError as read() does, and when there is no such variant.
ReadScene read_variant(const std::filesystem::path& path, const std::string& name,
                       const std::vector<std::string>& overrides = {});

/// The same for text that is already in memory; `name` stands for the file in messages.
ReadScene read_text(const std::string& text, const std::string& name, const std::vector<std::string>& overrides = {});

}  // namespace blockweir::scene
