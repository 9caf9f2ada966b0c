// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/front_kernels.hpp"

#include <cmath>

#include "bridge/results/wide_vectors.hpp"

namespace blockweir::reservoir {
namespace {

/// Subtracts f_j a_j of so many columns a_j from y, from row `from` on, where f_j is in a_j. `height`: from one column
/// to the next.
template <std::size_t count>
[[gnu::always_inline]] inline void subtract(const double* a, std::size_t height, std::size_t from, std::size_t rows,
                                            double* __restrict y) {
  double f[count];
  for (std::size_t j = 0; j < count; ++j) f[j] = a[j * height + from];
  for (std::size_t i = from; i < rows; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < count; ++j) sum += f[j] * a[j * height + i];
    y[i] -= sum;
  }
}

/// Values side by side, wherever they begin.
using Four = double __attribute__((vector_size(4 * sizeof(double)), aligned(sizeof(double)), may_alias));

/// A row of right-hand sides.
struct [[gnu::may_alias]] Row {
  Four part[side_width / 4];

  [[gnu::always_inline]] void subtract(double factor, const Row& other) {
    for (std::size_t w = 0; w < side_width / 4; ++w) part[w] -= factor * other.part[w];
  }
  [[gnu::always_inline]] void add(double factor, const Row& other) {
    for (std::size_t w = 0; w < side_width / 4; ++w) part[w] += factor * other.part[w];
  }
  [[gnu::always_inline]] void multiply(double factor) {
    for (Four& values : part) values *= factor;
  }
};

}  // namespace

BLOCKWEIR_WIDE_VECTORS bool eliminate(const Panel<double>& panel, const double* least, double* square) {
  const std::size_t height = panel.height;
  for (std::size_t j = 0; j < panel.columns; ++j) {
    double* column = panel.values + j * height;
    if (!(column[j] > least[j])) return false;
    const double scale = 1 / std::sqrt(column[j]);
    for (std::size_t i = j; i < height; ++i) column[i] *= scale;
    for (std::size_t k = j + 1; k < panel.columns; ++k) {
      subtract<1>(column, height, k, height, panel.values + k * height);
    }
  }
  const std::size_t rows = panel.below();
  for (std::size_t k = 0; k < rows; ++k) {
    const double* a = panel.values + panel.columns;
    double* y = square + k * rows;
    std::size_t left = panel.columns;
    for (; left >= 4; left -= 4, a += 4 * height) subtract<4>(a, height, k, rows, y);
    for (; left >= 2; left -= 2, a += 2 * height) subtract<2>(a, height, k, rows, y);
    if (left > 0) subtract<1>(a, height, k, rows, y);
  }
  return true;
}

void add_square(const double* child, std::size_t rows, const std::uint32_t* onto, const Panel<double>& panel,
                double* square) {
  for (std::size_t k = 0; k < rows; ++k, child += rows) {
    const bool of_factor = onto[k] < panel.columns;
    double* y = of_factor ? panel.values + onto[k] * panel.height : square + (onto[k] - panel.columns) * panel.below();
    const std::size_t above = of_factor ? 0 : panel.columns;
    for (std::size_t i = k; i < rows; ++i) y[onto[i] - above] += child[i];
  }
}

void forward(const Panel<const double>& panel, double* x) {
  double* own = x + panel.first;
  for (std::size_t j = 0; j < panel.columns; ++j) {
    const double* l = panel.values + j * panel.height;
    own[j] /= l[j];
    for (std::size_t k = j + 1; k < panel.columns; ++k) own[k] -= l[k] * own[j];
    for (std::size_t i = panel.columns; i < panel.height; ++i) x[panel.rows[i - panel.columns]] -= l[i] * own[j];
  }
}

void backward(const Panel<const double>& panel, double* x) {
  double* own = x + panel.first;
  for (std::size_t j = panel.columns; j-- > 0;) {
    const double* l = panel.values + j * panel.height;
    for (std::size_t k = j + 1; k < panel.columns; ++k) own[j] -= l[k] * own[k];
    double sum = 0;
    for (std::size_t i = panel.columns; i < panel.height; ++i) sum += l[i] * x[panel.rows[i - panel.columns]];
    own[j] = (own[j] - sum) / l[j];
  }
}

BLOCKWEIR_WIDE_VECTORS void forward_sides(const Panel<const double>& panel, double* x) {
  auto* rows = reinterpret_cast<Row*>(x);
  Row* own = rows + panel.first;
  for (std::size_t j = 0; j < panel.columns; ++j) {
    const double* l = panel.values + j;
    for (std::size_t k = 0; k < j; ++k) own[j].subtract(l[k * panel.height], own[k]);
    own[j].multiply(1 / l[j * panel.height]);
  }
  for (std::size_t i = panel.columns; i < panel.height; ++i) {
    Row& to = rows[panel.rows[i - panel.columns]];
    Row y = to;
    for (std::size_t j = 0; j < panel.columns; ++j) y.subtract(panel.values[j * panel.height + i], own[j]);
    to = y;
  }
}

BLOCKWEIR_WIDE_VECTORS void backward_sides(const Panel<const double>& panel, double* x) {
  auto* rows = reinterpret_cast<Row*>(x);
  Row* own = rows + panel.first;
  for (std::size_t j = panel.columns; j-- > 0;) {
    const double* l = panel.values + j * panel.height;
    Row y = own[j];
    for (std::size_t k = j + 1; k < panel.columns; ++k) y.subtract(l[k], own[k]);
    for (std::size_t i = panel.columns; i < panel.height; ++i) y.subtract(l[i], rows[panel.rows[i - panel.columns]]);
    y.multiply(1 / l[j]);
    own[j] = y;
  }
}

/// In two halves, whose sums a processor can hold.
BLOCKWEIR_WIDE_VECTORS void add_product(const double* a, const double* b, std::size_t rows, double* sum) {
  constexpr std::size_t half = side_width / 2;
  const auto* of_b = reinterpret_cast<const Row*>(b);
  for (std::size_t from = 0; from < side_width; from += half) {
    auto* to = reinterpret_cast<Row*>(sum) + from;
    Row sums[half];
    for (std::size_t i = 0; i < half; ++i) sums[i] = to[i];
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t i = 0; i < half; ++i) sums[i].add(a[r * side_width + from + i], of_b[r]);
    }
    for (std::size_t i = 0; i < half; ++i) to[i] = sums[i];
  }
}

}  // namespace blockweir::reservoir
