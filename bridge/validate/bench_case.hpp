// SPDX-License-Identifier: GPL-3.0-or-later
// A scene and the settings that its bench compares.
#pragma once

#include <optional>

#include "bridge/scene/read/entry.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// A point of a bench before it has been measured.
struct BenchSetting {
  std::string curve;
  std::string key_and_value;
  scene::SettingEntry entry{};  ///< that states it, with what holds for the curve
  Settings all{};               ///< with those of the command line
  bool inproc = false;
};

/// The same scene, launched otherwise: no setting that a scene could take over.
constexpr const char* one_process = "--inproc";

struct BenchCase {
  std::filesystem::path scene;
  std::vector<BenchSetting> settings{};       ///< the first is the scene as it stands
  std::optional<BenchSetting> finer_steps{};  ///< whose motion the others' is held against
};

/// Curves of the scene: its [[bench]], and each [[order]] of its first figure; only the scene as it stands where it has
/// no [[bench]]. `brief`: the ends of each curve. Every setting is checked: throws scene::SceneError.
BenchCase bench_case(const std::filesystem::path& scene, const Settings& overrides, bool brief);

}  // namespace blockweir::study
