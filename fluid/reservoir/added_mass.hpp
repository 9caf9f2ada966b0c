// SPDX-License-Identifier: GPL-3.0-or-later
// Added mass of all motions of a body of water with all, and its pressures by unit accelerations of all that it wets.
#pragma once

#include <Eigen/Core>

#include "bridge/process/face_motion.hpp"
#include "fluid/reservoir/pressure_equation.hpp"

namespace blockweir::reservoir {

/// One of a motion's three (FaceMotions), or the ground along x or y: the fixed blocks, the bed and a far end that is a
/// wall.
struct Mode {
  int motion = -1;  ///< -1: the ground
  int axis = 0;
};

/// The answer of one geometry to unit accelerations over one window, from rest.
struct WaterAnswer {
  std::vector<Mode> modes;                       ///< three for each motion, then two of the ground
  std::vector<hydrostatic::WetInterval> panels;  ///< sides of the mesh on blocks' faces, along their edges
  std::vector<std::array<int, 3>> panel_nodes;   ///< at s_from, between and at s_to of each
  Eigen::SparseMatrix<double> flux;              ///< nodes x modes, g of PressureEquation
  Eigen::MatrixXd mass;  ///< modes x modes: the water's force on i is -sum mass_ij a_j [kg/m, kg, kg m]

  /// Pressures at s_from and s_to of each panel with the same force and moment as the nodal pressures p [Pa], column by
  /// column.
  [[nodiscard]] Eigen::MatrixXd on_panels(const Eigen::MatrixXd& p) const;
  /// 2 panels x modes, at s_from and s_to of each [Pa per m/s2, rad/s2 or 1/s2].
  [[nodiscard]] Eigen::MatrixXd pressures(const PressureEquation& equation) const;
};

/// `moves`: motion of a point on a face, three unknowns a motion; no unknowns on the ground.
WaterAnswer answer_of(const WaterMesh& mesh, const PressureEquation& equation, const process::FaceMotion& moves);

}  // namespace blockweir::reservoir
