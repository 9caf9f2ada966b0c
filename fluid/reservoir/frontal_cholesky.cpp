// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/frontal_cholesky.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

/// Of a pivot, of its matrix's diagonal: below it is round-off.
constexpr double least_pivot = 1e-12;

constexpr Eigen::Index width = side_width;

using Right = Eigen::SparseMatrix<double>;

}  // namespace

bool FrontalCholesky::factorize(const Eigen::SparseMatrix<double>& lower) {
  factor_.resize(fronts_.values);
  work_.resize(fronts_.work);
  std::vector<double> least;
  std::size_t entry = 0;
  std::size_t child = 0;
  for (std::size_t f = 0; f < fronts_.front.size(); ++f) {
    const Front& front = fronts_.front[f];
    const Panel<double> panel = this->panel(f, factor_.data());
    std::fill_n(panel.values, front.columns * front.height(), 0.0);
    for (; entry < fronts_.entry_to[f]; ++entry) {
      factor_[fronts_.entry[entry].to] = lower.valuePtr()[fronts_.entry[entry].value];
    }
    least.clear();
    for (std::size_t j = 0; j < front.columns; ++j) least.push_back(least_pivot * panel.values[j * front.height() + j]);
    double* square = work_.data() + front.left;
    std::fill_n(square, front.below * front.below, 0.0);
    for (; child < fronts_.child_to[f]; ++child) {
      const Front& c = fronts_.front[fronts_.child[child]];
      add_square(work_.data() + c.left, c.below, fronts_.onto.data() + c.row, panel, square);
    }
    if (!eliminate(panel, least.data(), square)) return false;
  }
  return true;
}

template <class Value>
Panel<Value> FrontalCholesky::panel(std::size_t front, Value* factor) const {
  const Front& f = fronts_.front[front];
  return {factor + f.panel, f.columns, f.height(), f.first, fronts_.rows.data() + f.row};
}

Eigen::VectorXd FrontalCholesky::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd x(right.size());
  Numbers rows;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x[row_of(i)] = right[i];
    if (right[i] != 0) rows.push_back(static_cast<std::size_t>(row_of(i)));
  }
  for (const std::size_t f : fronts_above(rows)) forward(panel(f, factor_.data()), x.data());
  for (std::size_t f = fronts_.front.size(); f-- > 0;) backward(panel(f, factor_.data()), x.data());
  Eigen::VectorXd solution(right.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) solution[i] = x[row_of(i)];
  return solution;
}

/// Those of which one of these rows is, and all above.
FrontalCholesky::Numbers FrontalCholesky::fronts_above(const Numbers& rows) const {
  std::vector<char> marked(fronts_.front.size(), 0);
  for (const std::size_t row : rows) {
    for (auto f = static_cast<int>(fronts_.of_row[row]); f >= 0 && marked[at(f)] == 0;
         f = fronts_.front[at(f)].parent) {
      marked[at(f)] = 1;
    }
  }
  Numbers above;
  for (std::size_t f = 0; f < marked.size(); ++f) {
    if (marked[f] != 0) above.push_back(f);
  }
  return above;
}

/// L^-1 of some columns, from `first` on, in x, which is zero. Returns the fronts where it is not zero.
FrontalCholesky::Numbers FrontalCholesky::forward_from(const Right& right, Eigen::Index first, Sides& x) const {
  Numbers rows;
  for (Eigen::Index k = 0; k < std::min(width, right.cols() - first); ++k) {
    for (Right::InnerIterator b(right, first + k); b; ++b) {
      x(row_of(b.row()), k) = b.value();
      rows.push_back(static_cast<std::size_t>(row_of(b.row())));
    }
  }
  Numbers fronts = fronts_above(rows);
  for (const std::size_t f : fronts) forward_sides(panel(f, factor_.data()), x.data());
  return fronts;
}

void FrontalCholesky::clear(const Numbers& fronts, Sides& x) const {
  for (const std::size_t f : fronts) {
    const Front& front = fronts_.front[f];
    std::fill_n(x.data() + front.first * side_width, front.columns * side_width, 0);
  }
}

Eigen::MatrixXd FrontalCholesky::flexibility(const Right& right) const {
  struct Half {  // L^-1 of some columns, in the rows of these fronts' columns
    Eigen::Index first;
    Numbers fronts;
    std::vector<double> rows;
  };
  std::vector<Half> halves;
  Eigen::MatrixXd products(right.cols(), right.cols());
  Sides x = Sides::Zero(right.rows(), width);
  std::vector<Eigen::Index> seen_by(fronts_.front.size(), -1);
  for (Eigen::Index first = 0; first < right.cols(); first += width) {
    Half& own = halves.emplace_back(Half{first, forward_from(right, first, x), {}});
    for (const std::size_t f : own.fronts) {
      const double* rows = x.data() + fronts_.front[f].first * side_width;
      own.rows.insert(own.rows.end(), rows, rows + fronts_.front[f].columns * side_width);
      seen_by[f] = first;
    }
    for (const Half& other : halves) {
      Eigen::Matrix<double, width, width, Eigen::RowMajor> product;
      product.setZero();
      const double* rows = other.rows.data();
      for (const std::size_t f : other.fronts) {
        const Front& front = fronts_.front[f];
        if (seen_by[f] == first) add_product(rows, x.data() + front.first * side_width, front.columns, product.data());
        rows += front.columns * side_width;
      }
      const Eigen::Index others = std::min(width, right.cols() - other.first);
      const Eigen::Index owns = std::min(width, right.cols() - first);
      products.block(other.first, first, others, owns) = product.topLeftCorner(others, owns);
      products.block(first, other.first, owns, others) = product.topLeftCorner(others, owns).transpose();
    }
    clear(own.fronts, x);
  }
  return products;
}

void FrontalCholesky::solve(const Right& right, const std::vector<int>& wanted, const Take& take) const {
  Numbers rows(wanted.size());
  std::transform(wanted.begin(), wanted.end(), rows.begin(), [&](int unknown) { return fronts_.row_of[at(unknown)]; });
  const Numbers up = fronts_above(rows);
  Sides x = Sides::Zero(right.rows(), width);
  Eigen::MatrixXd values(static_cast<Eigen::Index>(wanted.size()), width);
  for (Eigen::Index first = 0; first < right.cols(); first += width) {
    const Numbers fronts = forward_from(right, first, x);
    for (auto f = up.rbegin(); f != up.rend(); ++f) backward_sides(panel(*f, factor_.data()), x.data());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      values.row(static_cast<Eigen::Index>(i)) = x.row(static_cast<Eigen::Index>(rows[i]));
    }
    take(first, values.leftCols(std::min(width, right.cols() - first)));
    clear(fronts, x);
    clear(up, x);
  }
}

}  // namespace blockweir::reservoir
