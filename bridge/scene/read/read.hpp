// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a TOML file into a Scene. All problems of the file are collected and reported together.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
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
  std::vector<Diagnostic> notes;     ///< what was corrected
  std::vector<Diagnostic> warnings;  ///< keys without effect and unusual magnitudes; Scene::warnings has their messages
};

/// Throws SceneError with the warnings as errors, if there are any (--strict).
void refuse_warnings(const std::vector<Diagnostic>& warnings);

/// The scene file of `path`: the file itself, or scene.toml of a case's folder.
std::filesystem::path scene_file(const std::filesystem::path& path);

/// How much of a file is read. A variant, or a run of a study, is one scene: it has no variants and studies itself.
enum class Extent { whole_file, one_scene };

/// Reads and checks a scene. `path` is a file or a case's folder, which then contains scene.toml.
/// `overrides` are "dotted.key=value" in TOML syntax, as for `--set`. Throws SceneError with all errors
/// together.
ReadScene read(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
               Extent extent = Extent::whole_file);

/// Reads the scene with the settings of its [[variant]] `name`, then those of `overrides`. An empty name means the
/// scene itself. Throws SceneError as read() does, and if there is no such variant.
ReadScene read_variant(const std::filesystem::path& path, const std::string& name,
                       const std::vector<std::string>& overrides = {});
/// The same for one that the scene was found to have.
ReadScene read_variant(const std::filesystem::path& path, const Variant& variant,
                       const std::vector<std::string>& overrides = {});

/// Reads and checks text in memory; `name` replaces the file name in messages.
ReadScene read_text(const std::string& text, const std::string& name, const std::vector<std::string>& overrides = {},
                    Extent extent = Extent::whole_file);

/// Is this a section that Extent::one_scene leaves out: [[variant]], [[limit]] and the other studies?
bool is_of_whole_file(std::string_view section);

}  // namespace blockweir::scene
