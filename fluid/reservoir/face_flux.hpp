// SPDX-License-Identifier: GPL-3.0-or-later
// Flux through wet faces caused by unit accelerations of a structure's unknowns.
#pragma once

#include <map>

#include "bridge/process/face_motion.hpp"
#include "fluid/reservoir/water_mesh.hpp"

namespace blockweir::reservoir {

/// g of PressureEquation at the nodes, for every unknown that moves a wet face.
std::map<int, Eigen::VectorXd> flux_on_faces(const WaterMesh& mesh, const process::FaceMotion& moves);

}  // namespace blockweir::reservoir
