// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the figures that a scene may expect, and of the formulas that yield them. What they mean is the solid's
// (solid/output): a scene is refused for a wrong one before anything runs.
#pragma once

#include <string>
#include <vector>

namespace blockweir::scene {

/// `quantity` of [[expect]] and of studies: numbers, then words.
const std::vector<std::string>& quantity_names();
/// `formula` of these.
const std::vector<std::string>& formula_names();

}  // namespace blockweir::scene
