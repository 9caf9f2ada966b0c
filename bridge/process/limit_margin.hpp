// SPDX-License-Identifier: GPL-3.0-or-later
// The margin of a run by limit analysis: how far it is from failure, or by how much it fails. It depends on the scene
// only, so it is computed while the run is going on.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bridge/process/supervisor.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::process {

class LimitMargin {
 public:
  /// `scratch`: a folder for temporary files.
  explicit LimitMargin(const std::filesystem::path& scratch);

  /// False if limit analysis would answer another question: with moving water, shaking ground, or blocks that start in
  /// motion.
  [[nodiscard]] static bool suits(const scene::Scene& scene);

  /// The command that runs beside the processes of the run in `folder`.
  [[nodiscard]] Command command(const std::filesystem::path& folder) const;

  /// Adds "limit_analysis" to the summary, with a "text" for the report, once the command has ended; nothing unless the
  /// run's outcome is "stands" or "fails".
  void add_to(nlohmann::json& summary) const;

 private:
  std::filesystem::path answer_;
  std::filesystem::path log_;
};

}  // namespace blockweir::process
