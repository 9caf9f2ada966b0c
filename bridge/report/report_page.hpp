// SPDX-License-Identifier: GPL-3.0-or-later
// The report: one HTML file that needs no network. What it says is data; how it looks stands in page/.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

struct ReportParts {
  scene::Scene scene;
  std::filesystem::path run;          ///< its folder
  nlohmann::json summary;             ///< of the run
  nlohmann::json level;               ///< answer of blockweir level, or {"trouble": why none}
  nlohmann::json safety;              ///< load cases of blockweir safety, or the same
  nlohmann::json reliability;         ///< as reliability.json has it, or the same; null: nothing is uncertain
  std::string program;                ///< version, commit, compiler: a line each
  std::vector<std::string> commands;  ///< that give the figures again
  std::string home{};                 ///< folder in which an external fluid's command starts; empty without one
};

/// What the page shows: lengths in m, forces in N, pressures in Pa, times in s. Throws std::invalid_argument where the
/// run has no frames.
[[nodiscard]] nlohmann::json report_data(const ReportParts& parts);

/// The page with this data.
[[nodiscard]] std::string report_page(const nlohmann::json& data);

}  // namespace blockweir::picture
