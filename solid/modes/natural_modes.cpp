// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/modes/natural_modes.hpp"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/MatOp/SymShiftInvert.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace blockweir::solid {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr int few_unknowns = 60;
constexpr double free_share = 1e-4;  ///< of the typical frequency: what is slower is free
constexpr double of_contacts = 100;  ///< times the typical frequency: what is faster swings on contacts' springs

/// Eigenvalues from the lowest up, and their vectors.
struct Pairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

Pairs all_of(const Sparse& K, const Sparse& M) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> found{Eigen::MatrixXd(K), Eigen::MatrixXd(M)};
  return {found.eigenvalues(), found.eigenvectors()};
}

Pairs lowest_of(const Sparse& K, const Sparse& M, int count, double typical_omega) {
  using Solve = Spectra::SymShiftInvert<double, Eigen::Sparse, Eigen::Sparse>;
  using Multiply = Spectra::SparseSymMatProd<double>;
  const double below = -1e-3 * typical_omega * typical_omega;  // K may be singular
  Solve solve(K, M);
  Multiply multiply(M);
  const int basis = std::min(static_cast<int>(K.rows()), std::max(3 * count, 20));
  Spectra::SymGEigsShiftSolver<Solve, Multiply, Spectra::GEigsMode::ShiftInvert> solver(solve, multiply, count, basis,
                                                                                        below);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-11, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw std::runtime_error("the natural modes were not found: the iteration has not converged");
  }
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace

std::vector<NaturalMode> natural_modes(const Sparse& K, const Sparse& M, int count, double typical_omega) {
  const int known = std::min(count, static_cast<int>(K.rows()));
  const Pairs found =
      K.rows() <= few_unknowns || known > K.rows() / 2 ? all_of(K, M) : lowest_of(K, M, known, typical_omega);
  std::vector<NaturalMode> modes;
  for (Eigen::Index k = 0; k < known; ++k) {
    const Eigen::VectorXd shape = found.vectors.col(k);
    const double omega = std::sqrt(std::max(0.0, found.values[k]));
    if (omega > of_contacts * typical_omega) break;
    modes.push_back({omega < free_share * typical_omega ? 0 : omega, shape / std::sqrt(shape.dot(M * shape))});
  }
  return modes;
}

}  // namespace blockweir::solid
