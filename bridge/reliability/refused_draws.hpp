// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a [[random]] that no scene can have, such as a negative cohesion.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/scene/read/read.hpp"
#include "bridge/study/outcome_work.hpp"
#include "bridge/study/probability.hpp"

namespace blockweir::study {

/// A warning for each [[random]] if more than one in 10,000 of its values makes an invalid scene. `read`: the scene
/// with `overrides`. Throws scene::SceneError if even the median of a distribution does.
std::vector<scene::Diagnostic> refused_draws(const std::filesystem::path& scene, const scene::ReadScene& read,
                                             const Settings& overrides);

/// Why a point of the random variables has no answer. If a drawn value was refused: which one, and the
/// remedy.
std::string why_no_answer(const scene::Randomness& randomness, const Outcome& row);

/// Reads the scene at the least and the largest value of each variable. Throws scene::SceneError for what is refused
/// there: a sample would be.
void refuse_unsound(const std::filesystem::path& scene, const scene::Randomness& randomness,
                    const std::vector<RandomPoint>& points, const Settings& overrides);

/// Throws scene::SceneError if an override sets a key that a [[random]] draws: it would have no effect.
void refuse_overridden_draws(const scene::ReadScene& read, const Settings& overrides);

}  // namespace blockweir::study
