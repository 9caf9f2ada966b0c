// SPDX-License-Identifier: GPL-3.0-or-later
// The loads on a section, by kind with their resultants, for pictures.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/scene/scene.hpp"

namespace blockweir::picture {

constexpr int unknown_block = -1;  ///< of a panel whose block the run did not store; the loaded block can move

/// One entry for each load that acts at `time_s`, weight first: name; kind: "weight", "earthquake", "load",
/// "silt", "water", "ice", "added water" or "uplift"; force [x, y] (N/m), the resultant on moving blocks; at
/// [x, y] (m), its position; strips: lists of [x, y, force x, force y] (N/m2) along an edge;
/// from_downstream: for water outside joints, whether it is the downstream pool's. Without strips the force
/// acts at the point `at`. `water` is what `blockweir-limit` answers to its question "water"; uplift is the pressure in
/// joints on the ground, and on the upper one of two blocks.
[[nodiscard]] nlohmann::json acting_loads(const scene::Scene& scene, const nlohmann::json& water, double time_s);

/// Bolts: name, from and to (m), the blocks there (null: the ground), stiffness, prestress, and yield_n_per_m or null.
[[nodiscard]] nlohmann::json bolts_data(const scene::Scene& scene);

}  // namespace blockweir::picture
