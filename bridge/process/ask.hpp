// SPDX-License-Identifier: GPL-3.0-or-later
// Asks blockweir-limit a question about a scene, which needs no run.
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
  bool quiet = false;                ///< prints neither progress nor notes and warnings of the reader
  bool tells_progress = false;       ///< prints progress even if quiet
  bool no_progress = false;          ///< prints no progress
  std::optional<double> moment_s{};  ///< time whose loads and levels count; default: the run's end
};

struct Asked {
  std::filesystem::path folder;
  scene::Scene scene;
  nlohmann::json answer;
};

/// Refuses a folder whose files are not of an earlier answer: they would be overwritten. Makes one that is not there.
void make_answer_folder(const std::filesystem::path& folder);

/// `out`, or its default folder.
std::filesystem::path answer_folder(const std::string& question, const AskOptions& options);

/// `question` is "level", "safety", "modes" or "water"; the answer is also written to the folder as QUESTION.json.
/// Throws scene::SceneError, std::invalid_argument for a folder with other contents, Stopped, and std::runtime_error if
/// there is no answer.
Asked ask(const std::string& question, const AskOptions& options);

}  // namespace blockweir::process
