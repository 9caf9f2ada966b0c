// SPDX-License-Identifier: GPL-3.0-or-later
// Flux through wet faces caused by unit accelerations of a structure's unknowns.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "bridge/process/face_motion.hpp"
#include "fluid/reservoir/water_mesh.hpp"

namespace blockweir::reservoir {

/// Every unknown that moves a wet face, in order, and g of PressureEquation for each: nodes x unknowns.
struct FaceFlux {
  std::vector<int> unknown;
  Eigen::SparseMatrix<double> g;
  Eigen::MatrixX2d ground;  ///< the same for unit accelerations of the ground along x and y: of the bed, and of faces
                            ///< that no unknown moves
};
FaceFlux flux_on_faces(const WaterMesh& mesh, const process::FaceMotion& moves);

}  // namespace blockweir::reservoir
