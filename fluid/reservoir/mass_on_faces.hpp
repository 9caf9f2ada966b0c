// SPDX-License-Identifier: GPL-3.0-or-later
// The mass of water that a structure pushes, whatever the motions of its faces.
#pragma once

#include "bridge/process/face_motion.hpp"

namespace blockweir::reservoir {

/// Incompressible water under a level surface: M = rho G^T K^-1 G, G what the unknowns' unit accelerations let through
/// each wet face (PressureEquation). What process::WaterMass asks for.
Eigen::SparseMatrix<double> mass_on_faces(const scene::Scene& scene, const wire::Motion& motion, int unknowns,
                                          const process::FaceMotion& moves);

}  // namespace blockweir::reservoir
