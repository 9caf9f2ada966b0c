// SPDX-License-Identifier: GPL-3.0-or-later
// A scene and the settings that its bench compares.
#pragma once

#include <optional>

#include "bridge/scene/read/entry.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// A point of a bench before measurement.
struct BenchSetting {
  std::string curve;
  std::string key_and_value;
  scene::SettingEntry entry{};  ///< that states it, with the settings common to the curve
  Settings all{};               ///< including those of the command line
  bool inproc = false;
};

/// The same scene in one process: not a setting that a scene could adopt.
constexpr const char* one_process = "--inproc";

struct BenchCase {
  std::filesystem::path scene;
  std::vector<BenchSetting> settings{};       ///< the first is the scene itself
  std::optional<BenchSetting> finer_steps{};  ///< reference for errors of the motion
};

/// Curves of a scene: its [[bench]], and each [[order]] of its first figure; without a [[bench]] the scene itself only.
/// `brief`: only the ends of each curve. Every setting is checked: throws scene::SceneError.
BenchCase bench_case(const std::filesystem::path& scene, const Settings& overrides, bool brief);

}  // namespace blockweir::study
