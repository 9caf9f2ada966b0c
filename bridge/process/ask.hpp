// SPDX-License-Identifier: GPL-3.0-or-later
// A question about a scene, which blockweir-limit answers without a run.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bridge/process/stopped.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::process {

struct AskOptions {
  std::filesystem::path scene;
  std::filesystem::path out{};  ///< folder for the answer; empty: runs/CASE-QUESTION, or runs/CASE-VARIANT-QUESTION
  std::string variant{};        ///< one of the scene's [[variant]]; empty: the scene itself
  std::vector<std::string> overrides{};
  bool quiet = false;                ///< nothing of what the reader mends or warns of
  std::optional<double> moment_s{};  ///< whose loads and levels count in place of those of the run's end
};

struct Asked {
  std::filesystem::path folder;
  scene::Scene scene;
  nlohmann::json answer;
};

/// `out`, or where it is empty the folder that it stands for.
std::filesystem::path answer_folder(const std::string& question, const AskOptions& options);

/// `question` is "level", "safety", "modes" or "water"; the answer is in the folder, too, as QUESTION.json. Throws
/// scene::SceneError, std::invalid_argument for a folder that holds something else, Stopped, and std::runtime_error
/// where there is no answer.
Asked ask(const std::string& question, const AskOptions& options);

}  // namespace blockweir::process
