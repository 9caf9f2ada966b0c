// SPDX-License-Identifier: GPL-3.0-or-later
// Where the entries of a sparse Cholesky factor are, front by front (multifrontal method; Duff and Reid 1983, Liu
// 1992). A front is a dense matrix: columns of the factor that follow each other with the same rows below them, and the
// square of those rows, which it leaves to its parent.
#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

namespace blockweir::reservoir {

struct Front {
  std::size_t first = 0;    ///< column of the factor
  std::size_t columns = 0;  ///< of the factor
  std::size_t below = 0;    ///< rows below these columns
  std::size_t row = 0;      ///< Fronts::rows: where the rows below begin
  std::size_t panel = 0;    ///< of the factor's values: where its columns begin, each of `columns` + `below`
  std::size_t left = 0;     ///< of the work space: where the square begins that it leaves
  int parent = -1;

  [[nodiscard]] std::size_t height() const { return columns + below; }
};

/// For all matrices with entries in the same places.
struct Fronts {
  using Place = std::uint32_t;
  /// One of the matrix's values, and where it is among the factor's.
  struct Entry {
    Place value;
    Place to;
  };

  /// `lower`: lower half of a symmetric matrix with a full diagonal.
  explicit Fronts(const Eigen::SparseMatrix<double>& lower);

  std::vector<Place> row_of;    ///< of each unknown: its row in the factor
  std::vector<Front> front;     ///< children before their parent
  std::vector<Place> of_row;    ///< of each row of the factor: the front that has it among its columns
  std::vector<Place> child;     ///< all but roots, those of each front one after another
  std::vector<Place> child_to;  ///< of each front: where its children end in `child`
  std::vector<Place> rows;      ///< below all fronts' columns, in the factor
  std::vector<Place> onto;      ///< of each of `rows`: its row in the parent's front
  std::vector<Entry> entry;     ///< front by front
  std::vector<Place> entry_to;  ///< of each front: where its entries end in `entry`
  std::size_t values = 0;       ///< of the factor
  std::size_t work = 0;         ///< values of the work space

 private:
  void gather(const std::vector<std::vector<int>>& below);
  void connect();
  void locate(const Eigen::SparseMatrix<int>& full);
};

}  // namespace blockweir::reservoir
