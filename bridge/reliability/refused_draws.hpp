// SPDX-License-Identifier: GPL-3.0-or-later
// Values that a [[random]] may draw and that no scene can have, as a cohesion below 0.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/scene/read/read.hpp"
#include "bridge/study/outcome_work.hpp"

namespace blockweir::study {

/// A warning for each [[random]] of whose values more than one in 10,000 makes a scene that is refused. `read`: the
/// scene with `overrides`. Throws scene::SceneError where the middle of a distribution does.
std::vector<scene::Diagnostic> refused_draws(const std::filesystem::path& scene, const scene::ReadScene& read,
                                             const Settings& overrides);

/// Why a point of the random variables has no answer. Where a value that was drawn is refused: which one, and what to
/// do.
std::string why_no_answer(const scene::Randomness& randomness, const Outcome& row);

/// Throws scene::SceneError where an override sets what a [[random]] draws: it would have no effect.
void refuse_overridden_draws(const scene::ReadScene& read, const Settings& overrides);

}  // namespace blockweir::study
