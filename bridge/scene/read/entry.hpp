// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that a scene states itself, in a [[variant]] or a study: what is wrong with them is told at its place.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/scene/read/read.hpp"

namespace blockweir::scene {

/// An entry of a scene that sets keys of the scene otherwise.
struct SettingEntry {
  std::string name;                   ///< for messages: [[variant]] "dry base"
  int line = 0;                       ///< of the scene's file
  std::vector<std::string> settings;  ///< "dotted.key=value" each, as --set takes them
};

/// The scene with the overrides `all`: those of the entry, and of the command line. Throws SceneError whose diagnostics
/// name the entry, and its file and line for what it sets. So do warnings.
ReadScene read_entry(const std::filesystem::path& path, const SettingEntry& entry, const std::vector<std::string>& all);

/// Those of `overrides` that set one of `keys`, or a part of its value, whether they call an entry by its name or its
/// index. A key may have "=value" behind it. `scene`: with the overrides.
std::vector<std::string> overrides_of(const Scene& scene, const std::vector<std::string>& overrides,
                                      const std::vector<std::string>& keys);

}  // namespace blockweir::scene
