// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure of linear water beside boundaries that accelerate, by finite elements.
#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <optional>

#include "fluid/reservoir/frontal_cholesky.hpp"
#include "fluid/reservoir/water_matrices.hpp"

namespace blockweir::reservoir {

/// Pressure beyond that of still water at the nodes [Pa], its rate, and l of WindowAhead, 0 where nothing looks ahead.
struct PressureState {
  Eigen::VectorXd p;
  Eigen::VectorXd rate;
  Eigen::VectorXd loaded;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(p, rate, loaded);
  }
};

/// What waves have lifted of a body of water, 1.Mp, and its rate 1.Mp' [kg/m, kg/(m s)]. No pressure resists the mean
/// of a surface that has no open end: what a change of the mesh adds to it would grow with time.
struct LiftedWater {
  double amount = 0;
  double rate = 0;
};

/// M p'' + C p' + K p = -rho g over one window, g_i = int N_i a.n ds (water_matrices.hpp), a held in it: the mean of
/// what accelerates. Two implicit stages (SDIRK2, Alexander 1977): of second order, and it damps what the mesh does not
/// resolve. Both stages have the matrix K + C/b + M/b^2, b = (1 - 1/sqrt 2) T. Without M and C, K p = -rho g.
/// With theta, one stage up to b = theta T, and on to T along the same line: 1/2 is the trapezoidal rule.
class PressureEquation {
 public:
  /// `mesh` is to outlive it. `ground`: which blocks are part of it. Throws std::runtime_error where a body of water
  /// has no surface.
  PressureEquation(const WaterMesh& mesh, const WaterPhysics& physics, const std::vector<bool>& ground,
                   double window_s);

  /// The mesh's nodes have moved, or windows are of another length: factors anew, on the fronts that they have.
  void update(double window_s);

  /// g of an acceleration that is linear along each side; only sides that `moves` names move.
  using Acceleration = std::function<Point(const Point& x)>;
  using Moves = std::function<bool(const BoundarySide& side)>;
  [[nodiscard]] Eigen::VectorXd flux(const Moves& moves, const Acceleration& acceleration) const;
  [[nodiscard]] PressureState rest() const;
  /// From one window's end to that of the next, in which `flux` is g.
  void step(PressureState& state, const Eigen::VectorXd& flux) const;
  [[nodiscard]] LiftedWater lifted(const PressureState& state) const;
  /// Adds to the pressure and its rate, evenly, what is missing to `lifted`. Nothing where no waves run.
  void keep(const LiftedWater& lifted, PressureState& state) const;
  /// p of water at rest after one window of `flux`.
  [[nodiscard]] Eigen::VectorXd pressure(const Eigen::VectorXd& flux) const;
  /// The same for each column of `flux`. `take` gets the number of the first column and the pressures of some columns,
  /// at the nodes of blocks' faces; elsewhere they may be anything.
  using Take = std::function<void(Eigen::Index first, const Eigen::MatrixXd& p)>;
  void solve(const Eigen::SparseMatrix<double>& flux, const Take& take) const;
  /// Of the motions that `flux` has a column for: the water's force on i is -sum M_ij a_j.
  [[nodiscard]] Eigen::MatrixXd added_mass(const Eigen::SparseMatrix<double>& flux) const;

 private:
  [[nodiscard]] Eigen::VectorXd lifts() const;
  [[nodiscard]] Eigen::VectorXd at_unknowns(const Eigen::VectorXd& at_nodes) const;
  [[nodiscard]] Eigen::SparseMatrix<double> at_unknowns(const Eigen::SparseMatrix<double>& at_nodes) const;
  [[nodiscard]] Eigen::VectorXd at_nodes(const Eigen::VectorXd& at_unknowns) const;

  /// Of both stages. Its entries are in the same places at each call.
  [[nodiscard]] const Eigen::SparseMatrix<double>& matrix();
  void factorize(const Eigen::SparseMatrix<double>& matrix);

  const WaterMesh& mesh_;
  WaterPhysics physics_;
  std::vector<bool> ground_;
  double density_;
  bool remembers_;
  std::optional<double> theta_;
  double window_s_;
  Unknowns unknowns_;
  std::optional<StiffnessMatrix> stiffness_;  ///< of water that does not remember
  WaterMatrices matrices_;                    ///< of water that does
  Eigen::SparseMatrix<double> of_stages_;     ///< likewise
  std::optional<FrontalCholesky> factors_;
};

}  // namespace blockweir::reservoir
