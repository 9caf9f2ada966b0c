// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about a scene that need no run; the solid answers them, with still water. Defined in solid/answers.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/process/face_motion.hpp"
#include "bridge/process/sides.hpp"

namespace blockweir::process {

/// The reservoir level at which the scene fails, by equilibrium of the blocks and by limit analysis. Throws
/// std::invalid_argument for a scene without such a level, and std::runtime_error if no answer is found.
nlohmann::json level_answer(const scene::Scene& scene, const FluidMaker& make_fluid);

/// The method that finds a level: limit analysis, or equilibrium of the blocks.
enum class Capacity { limit, statics };

/// The failure level by one method only, for thousands of samples: outcome, level_m, empty_m and full_m, mode, joint,
/// head_m; of limit analysis upper_bound, and limit_analysis_note on what it takes otherwise than the blocks. Throws as
/// above.
nlohmann::json capacity_answer(const scene::Scene& scene, const FluidMaker& make_fluid, Capacity by);

/// The factor by which the strength of joints can be divided until the scene fails under the loads and levels of the
/// run's end, by both methods, and the forces on joints that run through the structure. Throws as above.
nlohmann::json safety_answer(const scene::Scene& scene, const FluidMaker& make_fluid);

/// That factor by limit analysis only, which is quick: `factor`, and its `mechanism`. Without a factor it has
/// `why_no_factor`, for example too many joints. Throws as above.
nlohmann::json margin_answer(const scene::Scene& scene, const FluidMaker& make_fluid);

/// The ten lowest natural modes of the structure at rest under the loads and levels of the run's end, with the joints
/// in their state at that time: "dry", and "wet" if there is water. Throws as above.
nlohmann::json modes_answer(const scene::Scene& scene, const FluidMaker& make_fluid, const WaterMass& water_mass);

/// The pressures of still water at the run's end on the blocks as drawn, by kind. Throws as above.
nlohmann::json water_answer(const scene::Scene& scene, const FluidMaker& make_fluid);

}  // namespace blockweir::process
