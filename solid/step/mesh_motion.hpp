// SPDX-License-Identifier: GPL-3.0-or-later
// A block with a mesh has the mean motion of its triangles.
#pragma once

#include "solid/step/step_trial.hpp"

namespace blockweir::solid {

/// Sets the block's displacement, deformation gradient F = R (I + E) and rates to the mean of its triangles.
void follow_triangles(const Model& model, const StepTrial& trial, State& state);

}  // namespace blockweir::solid
