// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures of a body of water by unit accelerations of all that it wets, and the added mass of all blocks with all.
#pragma once

#include <Eigen/Core>

#include "fluid/reservoir/pressure_equation.hpp"

namespace blockweir::reservoir {

/// A rigid motion that the water feels: of a block (0, 1: along x, y; 2: turn about its centroid), or of the ground (x,
/// y), which are the fixed blocks, the bed and a far end that is a wall.
struct Mode {
  int block = -1;  ///< -1: the ground
  int axis = 0;
};

/// The answer of one geometry to unit accelerations over one window, from rest.
struct WaterAnswer {
  std::vector<Mode> modes;                       ///< those of blocks in threes, the ground's two last
  std::vector<hydrostatic::WetInterval> panels;  ///< sides of the mesh on blocks' faces, along their edges
  std::vector<std::array<int, 3>> panel_nodes;   ///< at s_from, between and at s_to of each
  Eigen::SparseMatrix<double> flux;              ///< nodes x modes, g of PressureEquation
  Eigen::MatrixXd pressure;  ///< 2 panels x modes, at s_from and s_to of each [Pa per m/s2 or rad/s2]
  Eigen::MatrixXd mass;      ///< modes x modes: the water's force on i is -sum mass_ij a_j [kg/m, kg, kg m]

  /// Of panels, at s_from and s_to of each, of a pressure at the nodes: of the same force and moment [Pa].
  [[nodiscard]] Eigen::VectorXd on_panels(const Eigen::VectorXd& p) const;
};

/// `centroids`: where those of the blocks are now. `fixed`: which belong to the ground.
WaterAnswer answer_of(const WaterMesh& mesh, const PressureEquation& equation, const std::vector<Point>& centroids,
                      const std::vector<bool>& fixed);

}  // namespace blockweir::reservoir
