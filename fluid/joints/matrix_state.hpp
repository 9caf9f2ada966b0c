// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a sparse matrix to bytes and back, so that a factorization can be restored.
#pragma once

#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "bridge/checkpoint/archive.hpp"

namespace blockweir::joints {

inline std::string matrix_state(const Eigen::SparseMatrix<double>& matrix) {
  std::vector<int> rows;
  std::vector<int> columns;
  std::vector<double> values;
  for (int k = 0; k < matrix.outerSize(); ++k) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, k); entry; ++entry) {
      rows.push_back(static_cast<int>(entry.row()));
      columns.push_back(static_cast<int>(entry.col()));
      values.push_back(entry.value());
    }
  }
  return checkpoint::pack(matrix.rows(), rows, columns, values);
}

inline Eigen::SparseMatrix<double> matrix_of(const std::string& state) {
  Eigen::Index size = 0;
  std::vector<int> rows;
  std::vector<int> columns;
  std::vector<double> values;
  checkpoint::unpack(state, size, rows, columns, values);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < values.size(); ++i) entries.emplace_back(rows[i], columns[i], values[i]);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace blockweir::joints
