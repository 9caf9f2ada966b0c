// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/filling_factor.hpp"

#include <Eigen/SparseLU>

#include "fluid/joints/matrix_state.hpp"

namespace blockweir::joints {

struct FillingFactor::Factor : Eigen::SparseLU<Eigen::SparseMatrix<double>> {};

FillingFactor::FillingFactor() : factor_(std::make_unique<Factor>()) {}

FillingFactor::~FillingFactor() = default;

bool FillingFactor::fits(const Eigen::SparseMatrix<double>& matrix) const {
  return keeps_ && made_ && matrix_.rows() == matrix.rows() && matrix_.nonZeros() == matrix.nonZeros();
}

bool FillingFactor::make(const Eigen::SparseMatrix<double>& matrix) {
  if (!fits(matrix)) factor_->analyzePattern(matrix);
  factor_->factorize(matrix);
  made_ = factor_->info() == Eigen::Success;
  matrix_ = matrix;
  ++count_;
  return made_;
}

Eigen::VectorXd FillingFactor::solve(const Eigen::VectorXd& right) const {
  return factor_->solve(right);
}

std::string FillingFactor::state() const {
  return checkpoint::pack(made_, matrix_state(matrix_), count_, kept_);
}

void FillingFactor::restore(const std::string& state) {
  bool made = false;
  std::string factored;
  long count = 0;
  checkpoint::unpack(state, made, factored, count, kept_);
  made_ = false;
  if (made) make(matrix_of(factored));
  count_ = count;
}

}  // namespace blockweir::joints
