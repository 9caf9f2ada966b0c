// SPDX-License-Identifier: GPL-3.0-or-later
// Finite-element matrices of linear water: stiffness, mass and damping of its pressure.
#pragma once

#include <Eigen/SparseCore>
#include <limits>
#include <optional>

#include "fluid/reservoir/water_mesh.hpp"

namespace blockweir::reservoir {

/// What the water feels beside the motion of its boundary.
struct WaterPhysics {
  double density_kg_per_m3 = 1000;
  double sound_speed_m_per_s = std::numeric_limits<double>::infinity();  ///< infinite: incompressible
  double gravity_m_per_s2 = std::numeric_limits<double>::infinity();     ///< of surface waves; infinite: there are none
  double bottom_reflection = 1;  ///< share of a pressure wave that the ground throws back
  /// Of the rule by which time is stepped (pressure_equation.hpp); none: SDIRK2.
  std::optional<double> theta{};

  /// The pressure depends on what has been before.
  [[nodiscard]] bool remembers() const {
    return sound_speed_m_per_s < std::numeric_limits<double>::infinity() ||
           gravity_m_per_s2 < std::numeric_limits<double>::infinity();
  }
};

/// Number of each node's unknown, and how many there are. Still surfaces have none: -1.
struct Unknowns {
  std::vector<int> of_node;
  Eigen::Index count = 0;
};
Unknowns unknowns_of(const WaterMesh& mesh, bool surface_moves);

/// Weak form of (1/c^2) p'' = div grad p with p'' = -g dp/dn at the surface, n out of the water:
///
///     M p'' + C p' + K p = -rho g,   K = int grad N . grad N dA,   M = int N N dA / c^2 + int_surface N N ds / g,
///     C = int_ground q N N ds + int_far N N ds / c,   q = (1 - alpha)/((1 + alpha) c),
///
/// alpha the ground's reflection (Fenves and Chopra 1984). Where the mesh has an absorbing stretch, C grows by
/// 2 sigma M, sigma rising with the square of the way into the stretch. Lower halves.
struct WaterMatrices {
  Eigen::SparseMatrix<double> K;
  Eigen::SparseMatrix<double> C;
  Eigen::SparseMatrix<double> M;
};
/// `ground`: which blocks are part of it.
WaterMatrices matrices_of(const WaterMesh& mesh, const Unknowns& unknowns, const WaterPhysics& physics,
                          const std::vector<bool>& ground);

/// K alone, of a mesh whose nodes move: where its entries are is found once.
class StiffnessMatrix {
 public:
  StiffnessMatrix(const WaterMesh& mesh, const Unknowns& unknowns);

  /// For the nodes where they are now. Its entries are those of WaterMatrices::K, in the same places.
  [[nodiscard]] const Eigen::SparseMatrix<double>& of(const WaterMesh& mesh);

 private:
  Eigen::SparseMatrix<double> K_;
  std::vector<std::array<int, 21>> place_;  ///< of each triangle's entries, its lower half by rows; -1: none
};

/// int N_i N_j ds over a side of unit length, nodes from, middle, to.
Eigen::Matrix3d side_mass();

}  // namespace blockweir::reservoir
