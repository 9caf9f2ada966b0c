// SPDX-License-Identifier: GPL-3.0-or-later
// The dense parts of a factorization by fronts (fronts.hpp). Matrices are stored by columns, right-hand sides by rows.
#pragma once

#include <cstddef>
#include <cstdint>

namespace blockweir::reservoir {

/// The columns of the factor that a front has, and the rows of the factor below them.
template <class Value>
struct Panel {
  Value* values;
  std::size_t columns;
  std::size_t height;
  std::size_t first;          ///< row of the factor
  const std::uint32_t* rows;  ///< of the factor, below the columns

  [[nodiscard]] std::size_t below() const { return height - columns; }
};

/// Factorizes a panel and subtracts what follows from it from `square`, the lower half of that of the rows below. False
/// where a pivot is not above its `least`.
bool eliminate(const Panel<double>& panel, const double* least, double* square);

/// Adds the lower half of the square of so many rows that a child leaves to its parent's front. `onto`: the parent's
/// row of each.
void add_square(const double* child, std::size_t rows, const std::uint32_t* onto, const Panel<double>& panel,
                double* square);

/// A front's part of L y = b, and of L^T x = y. Solutions take the place of right-hand sides.
void forward(const Panel<const double>& panel, double* x);
void backward(const Panel<const double>& panel, double* x);

/// Right-hand sides at once, where there are many.
constexpr std::size_t side_width = 8;
void forward_sides(const Panel<const double>& panel, double* x);
void backward_sides(const Panel<const double>& panel, double* x);

/// Adds a^T b to `sum`: a and b of so many rows, all side_width wide.
void add_product(const double* a, const double* b, std::size_t rows, double* sum);

}  // namespace blockweir::reservoir
