// SPDX-License-Identifier: GPL-3.0-or-later
// What limit analysis says of a run: how far it is from failing, or by how much it fails. That depends on the scene
// alone, so it is found while the run goes on.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bridge/process/supervisor.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::process {

class LimitMargin {
 public:
  /// `scratch`: a folder for its files.
  explicit LimitMargin(const std::filesystem::path& scratch);

  /// False where the answer would be another question's: in water that moves, on ground that shakes, of blocks that are
  /// drawn on the move.
  [[nodiscard]] static bool suits(const scene::Scene& scene);

  /// Beside the processes of the run in `folder`.
  [[nodiscard]] Command command(const std::filesystem::path& folder) const;

  /// Adds "limit_analysis" to the summary, once the command has ended, with a "text" to tell; nothing where the run
  /// neither stands nor fails.
  void add_to(nlohmann::json& summary) const;

 private:
  std::filesystem::path answer_;
  std::filesystem::path log_;
};

}  // namespace blockweir::process
