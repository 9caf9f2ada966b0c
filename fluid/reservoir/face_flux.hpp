// SPDX-License-Identifier: GPL-3.0-or-later
// What unit accelerations of a structure's unknowns let through the water's wet faces.
#pragma once

#include <map>

#include "bridge/process/face_motion.hpp"
#include "fluid/reservoir/water_mesh.hpp"

namespace blockweir::reservoir {

/// g of PressureEquation at the nodes, for each unknown that moves a face.
std::map<int, Eigen::VectorXd> flux_on_faces(const WaterMesh& mesh, const process::FaceMotion& moves);

}  // namespace blockweir::reservoir
