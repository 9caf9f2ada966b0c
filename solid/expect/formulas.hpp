// SPDX-License-Identifier: GPL-3.0-or-later
// Closed-form solutions for comparison with a case, computed from the scene itself so that they follow its values.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::solid::expect {

/// Allowed names of `formula` in [[expect]].
std::vector<std::string> formula_names();

/// The value of `expectation.formula` for this scene; `of` names the joint or block. Throws std::runtime_error if the
/// scene has no such thing. Per metre of thickness, SI.
double formula(const scene::Scene& scene, const scene::Expectation& expectation);

}  // namespace blockweir::solid::expect
