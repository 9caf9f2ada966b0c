// SPDX-License-Identifier: GPL-3.0-or-later
// What blockweir reliability has found: as text, table and pictures.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/study/outcome_work.hpp"
#include "bridge/study/probability.hpp"

namespace blockweir::study {

/// CSV: a row a sample, with the values of the variables and how it has ended. Nothing of how long it took: the same
/// bits on every machine.
std::string sample_table(const scene::Randomness& randomness, const std::vector<RandomPoint>& points,
                         const std::vector<Outcome>& rows);

/// "normal, mean 30, deviation 2, at least 20".
std::string distribution_text(const scene::Distribution& distribution);

std::string reliability_text(const nlohmann::json& answer);

/// fragility.png, and sobol.png where there are indices, into the folder; says where.
void draw_reliability(const nlohmann::json& answer, const std::filesystem::path& folder);

}  // namespace blockweir::study
