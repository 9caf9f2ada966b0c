// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the tables of water in joints that a fluid writes (fluid/joints/flow_tables.hpp).
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blockweir::picture {

/// Rows and cells of a CSV file.
using Rows = std::vector<std::vector<std::string>>;

/// The complete rows of a table, column names first; empty if there is no such file. Still water writes it into the
/// run's folder, OpenFOAM's plugin into its case. They end before failure, if the run's summary has one: what falls
/// opens its joints wide, and their water says nothing of the structure.
Rows flow_rows(const std::filesystem::path& run, const std::string& name, const nlohmann::json& summary);

/// The rows of the last time, without the column names.
Rows last_rows(const Rows& rows);

/// The number in a cell; NaN if it is empty.
double number_in(const std::string& cell);

/// "drain gallery" for the column "drain_gallery_m2_per_s", "to air" for "to_air_m2_per_s".
std::string words_of_flow(const std::string& column);

/// Columns of joint_uplift.csv.
namespace uplift_column {
constexpr std::size_t joint = 1, length_m = 2, flow = 3, reynolds = 4, uplift = 5, triangular = 6, drained = 7,
                      full = 8;
}

}  // namespace blockweir::picture
