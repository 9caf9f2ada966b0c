// SPDX-License-Identifier: GPL-3.0-or-later
// [[expect_water]]: compares figures of OpenFOAM's water with the scene's stated values.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::openfoam {

/// Before a run: throws std::invalid_argument if a figure refers to the ground, whose forces are not recorded.
void require_water_columns(const scene::Scene& scene);

/// One check for each, as in summary.json, from the plugin's water.csv. Quantities are those of
/// scene::water_quantities: water_area_error (largest change of the water's area over its first value), front_arrival_s
/// (time at which the front passes at_m), fastest_m_per_s (at the end), added_mass_kg_per_m (horizontal force on block
/// `of` over its acceleration, least-squares fit), ground_added_mass_kg_per_m (the same over the ground's),
/// force_x_n_per_m and force_y_n_per_m (mean over the run's second half). Throws std::runtime_error for any other, and
/// if water.csv lacks a column.
nlohmann::json water_checks(const scene::Scene& scene, const std::filesystem::path& water_csv);

}  // namespace blockweir::openfoam
