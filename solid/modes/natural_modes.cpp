// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/modes/natural_modes.hpp"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solid/solve/symmetric_modes.hpp"

namespace blockweir::solid {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr int few_unknowns = 60;
constexpr double free_share = 1e-4;  ///< of the typical frequency: what is slower is free
constexpr double of_contacts = 100;  ///< times the typical frequency: what is faster swings on contacts' springs

/// (K - shift M)^-1 x, in the form that Spectra calls. With a shift below 0 the matrix is positive definite.
class ShiftedSolve {
 public:
  using Scalar = double;

  ShiftedSolve(const Sparse& K, const Sparse& M) : K_(K), M_(M) {}
  [[nodiscard]] Eigen::Index rows() const { return K_.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return K_.cols(); }
  void set_shift(double shift) {
    factors_.compute(K_ - shift * M_);
    if (factors_.info() != Eigen::Success)
      throw std::runtime_error(
          "no natural modes were found: the stiffness matrix has no factors; look for moduli and "
          "densities in wrong units");
  }
  void perform_op(const double* x, double* y) const {
    Eigen::VectorXd::Map(y, rows()) = factors_.solve(Eigen::VectorXd::Map(x, rows()));
  }

 private:
  const Sparse& K_;
  const Sparse& M_;
  Eigen::SimplicialLDLT<Sparse> factors_;
};

SymmetricModes lowest_of(const Sparse& K, const Sparse& M, int count, double typical_omega) {
  using Multiply = Spectra::SparseSymMatProd<double>;
  const double below = -1e-3 * typical_omega * typical_omega;  // K may be singular
  ShiftedSolve solve(K, M);
  Multiply multiply(M);
  const int basis = std::min(static_cast<int>(K.rows()), std::max(3 * count, 20));
  Spectra::SymGEigsShiftSolver<ShiftedSolve, Multiply, Spectra::GEigsMode::ShiftInvert> solver(solve, multiply, count,
                                                                                               basis, below);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-11, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw std::runtime_error(
        "no natural modes were found: the iteration did not converge; look for moduli and densities in wrong units");
  }
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace

std::vector<NaturalMode> natural_modes(const Sparse& K, const Sparse& M, int count, double typical_omega) {
  const int known = std::min(count, static_cast<int>(K.rows()));
  const bool all = K.rows() <= few_unknowns || known > K.rows() / 2;
  const SymmetricModes found =
      all ? symmetric_modes(Eigen::MatrixXd(K), Eigen::MatrixXd(M)) : lowest_of(K, M, known, typical_omega);
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
