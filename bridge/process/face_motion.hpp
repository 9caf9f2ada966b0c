// SPDX-License-Identifier: GPL-3.0-or-later
// How points on faces move with the unknowns of a structure, and the mass of water that such motions push.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::process {

/// A point of an edge of a block, at a fraction of its length.
struct FacePoint {
  int block = 0;
  int edge = 0;
  double s = 0;
};

/// Velocity of a point by unit rates of some of the structure's unknowns; of none where it is fixed.
struct PointMotion {
  std::vector<int> unknown;
  Eigen::Matrix2Xd by_unknown;
};

using FaceMotion = std::function<PointMotion(const FacePoint&)>;

/// Mass of the water that `unknowns` unknowns push, on blocks where `motion` says, at the levels of the run's end:
/// symmetric, unknowns x unknowns.
using WaterMass = std::function<Eigen::SparseMatrix<double>(const scene::Scene& scene, const wire::Motion& motion,
                                                            int unknowns, const FaceMotion& moves)>;

}  // namespace blockweir::process

namespace blockweir::reservoir {

/// Of incompressible water under a level surface: M = rho G^T K^-1 G, G what the unknowns' unit accelerations let
/// through each wet face (fluid/README.md). Defined by fluid/reservoir.
Eigen::SparseMatrix<double> mass_on_faces(const scene::Scene& scene, const wire::Motion& motion, int unknowns,
                                          const process::FaceMotion& moves);

}  // namespace blockweir::reservoir
