// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure of linear, incompressible water beside boundaries that accelerate, by finite elements.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <functional>

#include "fluid/reservoir/water_mesh.hpp"

namespace blockweir::reservoir {

/// Laplace's equation for the pressure p beyond that of still water, n out of the water:
///
///     div grad p = 0,   dp/dn = -rho a.n where the boundary has the acceleration a,   p = 0 at the surface.
///
/// Quadratic triangles: K p = -rho g, K_ij = int grad N_i . grad N_j dA, g_i = int N_i a.n ds.
class PressureEquation {
 public:
  /// Factors K. `mesh` is to outlive it. Throws std::runtime_error where K is singular.
  PressureEquation(const WaterMesh& mesh, double density_kg_per_m3);

  /// g of an acceleration that is linear along each side; only sides that `moves` names move.
  using Acceleration = std::function<Point(const Point& x)>;
  using Moves = std::function<bool(const BoundarySide& side)>;
  [[nodiscard]] Eigen::VectorXd flux(const Moves& moves, const Acceleration& acceleration) const;
  /// p at the nodes [Pa].
  [[nodiscard]] Eigen::VectorXd pressure(const Eigen::VectorXd& flux) const;
  [[nodiscard]] Eigen::Index unknowns() const { return free_; }

 private:
  [[nodiscard]] Eigen::SparseMatrix<double> stiffness() const;

  const WaterMesh& mesh_;
  double density_;
  std::vector<int> unknown_;  ///< of each node; -1 at the surface
  Eigen::Index free_ = 0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

/// int N_i N_j ds over a side of unit length, nodes from, middle, to.
Eigen::Matrix3d side_mass();

}  // namespace blockweir::reservoir
