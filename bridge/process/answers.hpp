// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene is asked without a run of its own: the solid answers, on still water. Defined in solid/answers.
#pragma once

#include <nlohmann/json.hpp>

#include "bridge/process/face_motion.hpp"
#include "bridge/process/sides.hpp"

namespace blockweir::process {

/// At which level of the reservoir it fails, by the blocks' own equilibrium and by limit analysis. Throws
/// std::invalid_argument for a scene that has no such level, and std::runtime_error where no answer is found.
nlohmann::json level_answer(const scene::Scene& scene, const FluidMaker& make_fluid);

/// By which way alone a level is found: limit analysis, or the blocks' own equilibrium.
enum class Capacity { limit, statics };

/// That level by one way alone, for samples by the thousand: outcome, level_m, empty_m and full_m, mode, joint, head_m;
/// is_exact of limit analysis. Throws as above.
nlohmann::json capacity_answer(const scene::Scene& scene, const FluidMaker& make_fluid, Capacity by);

/// By which factor the strength of its joints can be divided until it fails under the loads and levels of the run's
/// end, found likewise, and the forces on the joints that run through. Throws as above.
nlohmann::json safety_answer(const scene::Scene& scene, const FluidMaker& make_fluid);

/// That factor by limit analysis alone, which takes a moment: `factor`, and the `mechanism` that it fails by. Without a
/// factor it says `why_no_factor`, as of a scene of too many joints. Throws as above.
nlohmann::json margin_answer(const scene::Scene& scene, const FluidMaker& make_fluid);

/// The ten lowest natural modes of the structure at rest under the loads and levels of the run's end, its joints as
/// they are then: "dry", and "wet" where there is water. Throws as above.
nlohmann::json modes_answer(const scene::Scene& scene, const FluidMaker& make_fluid, const WaterMass& water_mass);

/// The pressures of its still water at the run's end, on blocks where they are drawn, kind by kind. Throws as above.
nlohmann::json water_answer(const scene::Scene& scene, const FluidMaker& make_fluid);

}  // namespace blockweir::process
