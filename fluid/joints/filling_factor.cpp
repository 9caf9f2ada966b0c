// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/filling_factor.hpp"

#include "fluid/joints/matrix_state.hpp"

namespace blockweir::joints {

bool FillingFactor::fits(const Eigen::SparseMatrix<double>& matrix) const {
  return keeps_ && made_ && of_.rows() == matrix.rows() && of_.nonZeros() == matrix.nonZeros();
}

bool FillingFactor::make(const Eigen::SparseMatrix<double>& matrix) {
  if (!fits(matrix)) factor_.analyzePattern(matrix);
  factor_.factorize(matrix);
  made_ = factor_.info() == Eigen::Success;
  of_ = matrix;
  ++count_;
  return made_;
}

std::string FillingFactor::state() const {
  return checkpoint::pack(made_, matrix_state(of_), count_, kept_);
}

void FillingFactor::restore(const std::string& state) {
  bool made = false;
  std::string of;
  long count = 0;
  checkpoint::unpack(state, made, of, count, kept_);
  made_ = false;
  if (made) make(matrix_of(of));
  count_ = count;
}

}  // namespace blockweir::joints
