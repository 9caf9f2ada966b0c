// SPDX-License-Identifier: GPL-3.0-or-later
// A block with a mesh follows its triangles.
#pragma once

#include "solid/step/step_trial.hpp"

namespace blockweir::solid {

/// Mean displacement and deformation gradient F = R (I + E) of the triangles, and their rates, as those of the block.
void follow_triangles(const Model& model, const StepTrial& trial, State& state);

}  // namespace blockweir::solid
