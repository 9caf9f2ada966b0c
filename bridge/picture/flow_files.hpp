// SPDX-License-Identifier: GPL-3.0-or-later
// The tables that a fluid writes of the water in joints (fluid/joints/flow_tables.hpp).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace blockweir::picture {

/// Of a CSV file, cell by cell.
using Rows = std::vector<std::vector<std::string>>;

/// Whole rows of a table of a run's fluid, the names first; none where there is no such file. Still water writes into
/// the run's folder, OpenFOAM's plugin into its case.
Rows flow_rows(const std::filesystem::path& run, const std::string& name);

/// Those of the last time; without the names.
Rows last_rows(const Rows& rows);

/// A number of a cell; NaN where it is empty.
double figure(const std::string& cell);

/// Of "drain_gallery_m2_per_s" or "to_air_m2_per_s": "drain gallery", "to air".
std::string words_of_flow(const std::string& column);

/// Rows of joint_uplift.csv.
namespace uplift_column {
constexpr std::size_t joint = 1, length_m = 2, flow = 3, reynolds = 4, uplift = 5, triangular = 6, drained = 7,
                      full = 8;
}

}  // namespace blockweir::picture
