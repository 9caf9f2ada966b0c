// SPDX-License-Identifier: GPL-3.0-or-later
// The report: one HTML file that needs no network. Its data comes from here, its appearance from page/.
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
  nlohmann::json level;               ///< answer of blockweir level, or {"trouble": reason}
  nlohmann::json safety;              ///< load cases of blockweir safety, or the same
  nlohmann::json reliability;         ///< content of reliability.json, or the same; null: no uncertain numbers
  std::string program;                ///< version, commit, compiler: a line each
  std::vector<std::string> commands;  ///< that reproduce the figures
  std::string home{};                 ///< folder in which an external fluid's command starts; empty: no such fluid
};

/// The data of the page: lengths in m, forces in N, pressures in Pa, times in s. Throws std::invalid_argument if the
/// run has no frames.
[[nodiscard]] nlohmann::json report_data(const ReportParts& parts);

/// The page with this data.
[[nodiscard]] std::string report_page(const nlohmann::json& data);

}  // namespace blockweir::picture
