// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/fronts.hpp"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

using Columns = std::vector<std::vector<int>>;

/// The unknown that each column of the factor is of, so that few entries fill in.
std::vector<int> order_of(const Eigen::SparseMatrix<double>& lower) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + order.size()};
}

/// Rows of the entries below the diagonal of each column of the factor, the first of them in front: the column's parent
/// in the elimination tree.
Columns filled(const Eigen::SparseMatrix<int>& full, const std::vector<int>& order) {
  std::vector<int> number(order.size());
  for (std::size_t j = 0; j < order.size(); ++j) number[at(order[j])] = static_cast<int>(j);
  Columns below(order.size());
  Columns children(order.size());
  std::vector<int> seen_by(order.size(), -1);
  std::vector<int> rows;
  for (int j = 0; at(j) < order.size(); ++j) {
    rows.clear();
    const auto add = [&](int row) {
      if (row > j && std::exchange(seen_by[at(row)], j) != j) rows.push_back(row);
    };
    for (Eigen::SparseMatrix<int>::InnerIterator a(full, order[at(j)]); a; ++a) {
      add(number[at(static_cast<int>(a.row()))]);
    }
    for (const int child : children[at(j)]) std::for_each(below[at(child)].begin(), below[at(child)].end(), add);
    if (rows.empty()) continue;
    std::iter_swap(rows.begin(), std::min_element(rows.begin(), rows.end()));
    children[at(rows.front())].push_back(j);
    below[at(j)] = rows;
  }
  return below;
}

/// New numbers of the columns: children before parents, each subtree in one piece.
std::vector<int> in_postorder(const Columns& below) {
  std::vector<int> size(below.size(), 1);  // of the subtrees
  for (std::size_t j = 0; j < below.size(); ++j) {
    if (!below[j].empty()) size[at(below[j].front())] += size[j];
  }
  std::vector<int> number(below.size());
  std::vector<int> end(below.size());  // of what is left for a column's children
  int end_of_all = static_cast<int>(below.size());
  for (std::size_t j = below.size(); j-- > 0;) {
    int& last = below[j].empty() ? end_of_all : end[at(below[j].front())];
    number[j] = end[j] = last - 1;
    last -= size[j];
  }
  return number;
}

Columns renumbered(Columns below, const std::vector<int>& number) {
  Columns renumbered(below.size());
  for (std::size_t j = 0; j < below.size(); ++j) {
    auto& rows = renumbered[at(number[j])] = std::move(below[j]);
    for (int& row : rows) row = number[at(row)];
    std::sort(rows.begin(), rows.end());
  }
  return renumbered;
}

}  // namespace

Fronts::Fronts(const Eigen::SparseMatrix<double>& lower) {
  Eigen::SparseMatrix<int> numbered = lower.cast<int>();
  std::iota(numbered.valuePtr(), numbered.valuePtr() + numbered.nonZeros(), 0);
  const Eigen::SparseMatrix<int> full = numbered.selfadjointView<Eigen::Lower>();
  const std::vector<int> order = order_of(lower);
  Columns below = filled(full, order);
  const std::vector<int> number = in_postorder(below);
  row_of.resize(order.size());
  for (std::size_t j = 0; j < order.size(); ++j) row_of[at(order[j])] = static_cast<Place>(number[j]);
  gather(renumbered(std::move(below), number));
  connect();
  locate(full);
}

/// Columns into fronts.
void Fronts::gather(const Columns& below) {
  for (std::size_t j = 0; j < below.size(); ++j) {
    const bool goes_on = j > 0 && below[j - 1].size() == below[j].size() + 1 && at(below[j - 1].front()) == j;
    if (!goes_on) front.push_back({.first = j});
    ++front.back().columns;
    of_row.push_back(static_cast<Place>(front.size() - 1));
  }
  for (Front& f : front) {
    const auto& rows_below = below[f.first + f.columns - 1];
    f.below = rows_below.size();
    f.row = rows.size();
    rows.insert(rows.end(), rows_below.begin(), rows_below.end());
    f.panel = values;
    values += f.columns * f.height();
    if (f.below > 0) f.parent = static_cast<int>(of_row[rows[f.row]]);
  }
}

/// What a front leaves stands until its parent takes it. Fronts of even and of odd depth each have a stack: a parent
/// takes from the top of one and leaves on the other.
void Fronts::connect() {
  std::vector<std::vector<Place>> children(front.size());
  std::vector<std::size_t> depth(front.size(), 0);
  for (std::size_t f = front.size(); f-- > 0;) {
    if (front[f].parent >= 0) depth[f] = depth[at(front[f].parent)] + 1;
  }
  std::array<std::size_t, 2> top{};
  std::array<std::size_t, 2> highest{};
  for (std::size_t f = 0; f < front.size(); ++f) {
    Front& own = front[f];
    const std::size_t stack = depth[f] % 2;
    own.left = top[stack];
    top[stack] += own.below * own.below;
    highest[stack] = std::max(highest[stack], top[stack]);
    for (const Place c : children[f]) top[1 - stack] -= front[c].below * front[c].below;
    child.insert(child.end(), children[f].begin(), children[f].end());
    child_to.push_back(static_cast<Place>(child.size()));
    if (own.parent >= 0) children[at(own.parent)].push_back(static_cast<Place>(f));
  }
  for (std::size_t f = 0; f < front.size(); ++f) front[f].left += depth[f] % 2 == 0 ? 0 : highest[0];
  work = highest[0] + highest[1];
}

/// `full`: the matrix, with the number of each value in its place.
void Fronts::locate(const Eigen::SparseMatrix<int>& full) {
  std::vector<int> unknown(row_of.size());  // of each row
  for (std::size_t i = 0; i < row_of.size(); ++i) unknown[row_of[i]] = static_cast<int>(i);
  std::vector<Place> down(row_of.size());  // of each row: where a front has it
  onto.resize(rows.size());
  std::size_t next_child = 0;
  for (std::size_t f = 0; f < front.size(); ++f) {
    const Front& own = front[f];
    for (std::size_t j = 0; j < own.columns; ++j) down[own.first + j] = static_cast<Place>(j);
    for (std::size_t i = 0; i < own.below; ++i) down[rows[own.row + i]] = static_cast<Place>(own.columns + i);
    for (std::size_t j = 0; j < own.columns; ++j) {
      for (Eigen::SparseMatrix<int>::InnerIterator a(full, unknown[own.first + j]); a; ++a) {
        const Place row = row_of[static_cast<std::size_t>(a.row())];
        if (row < own.first + j) continue;
        entry.push_back({static_cast<Place>(a.value()), static_cast<Place>(own.panel + j * own.height() + down[row])});
      }
    }
    entry_to.push_back(static_cast<Place>(entry.size()));
    for (; next_child < child_to[f]; ++next_child) {
      const Front& from = front[child[next_child]];
      for (std::size_t i = from.row; i < from.row + from.below; ++i) onto[i] = down[rows[i]];
    }
  }
}

}  // namespace blockweir::reservoir
