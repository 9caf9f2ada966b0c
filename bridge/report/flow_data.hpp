// SPDX-License-Identifier: GPL-3.0-or-later
// The water in joints before failure or at the end of a run, for the report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace blockweir::picture {

/// At the last moment before failure, or at the end. Null if no water flows through joints. Otherwise `time_s`;
/// `joints`, those with the highest uplift, with flow, Reynolds number and the forces of uplift and of the guideline
/// laws; `left_out`, the number of further joints; `flows`, a list of `name` and `m2_per_s`: open water, air and each
/// drain.
nlohmann::json flow_data(const std::filesystem::path& run, const nlohmann::json& summary);

}  // namespace blockweir::picture
