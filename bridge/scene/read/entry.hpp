// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that a scene itself makes, in a [[variant]] or a study. Their errors name the entry and its line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/scene/read/read.hpp"

namespace blockweir::scene {

/// An entry of a scene that changes keys of the scene.
struct SettingEntry {
  std::string name;                   ///< for messages, e.g. [[variant]] "dry base"
  int line = 0;                       ///< of the scene's file
  std::vector<std::string> settings;  ///< "dotted.key=value" each, as for --set
};

/// Reads the one scene that the file is with the overrides `all`: those of the entry, then those of the command line.
/// Throws SceneError whose diagnostics name the entry, with its file and line where the entry is the cause. Warnings do
/// the same.
ReadScene read_entry(const std::filesystem::path& path, const SettingEntry& entry, const std::vector<std::string>& all);

/// Those of `overrides` that set one of `keys` or a part of its value. Entries may be given by name or by index, and a
/// key may be followed by "=value". `scene` is read with the overrides.
std::vector<std::string> overrides_of(const Scene& scene, const std::vector<std::string>& overrides,
                                      const std::vector<std::string>& keys);

}  // namespace blockweir::scene
