// SPDX-License-Identifier: GPL-3.0-or-later
// Results of blockweir reliability as text, table and pictures.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bridge/study/outcome_work.hpp"
#include "bridge/study/probability.hpp"

namespace blockweir::study {

/// CSV: one row for each sample, with the values of the variables and the outcome. No computing times, so that all
/// machines give the same bits.
std::string sample_table(const scene::Randomness& randomness, const std::vector<RandomPoint>& points,
                         const std::vector<Outcome>& rows);

/// "normal, mean 30, deviation 2, at least 20".
std::string distribution_text(const scene::Distribution& distribution);

std::string reliability_text(const nlohmann::json& answer);

/// gnuplot's commands: two bars for each variable.
std::string sobol_figure(const nlohmann::json& answer);

/// Draws fragility.png, and sobol.png if there are indices, into the folder and prints their paths.
void draw_reliability(const nlohmann::json& answer, const std::filesystem::path& folder);

}  // namespace blockweir::study
