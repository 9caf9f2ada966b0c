// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cell of a plane mesh that contains a point. C++17: the OpenFOAM plugin includes this.
#pragma once

#include "fluid/openfoam/polygon_clip.hpp"

namespace blockweir::openfoam {

/// Bins as wide as the smallest cell; a search tests the few cells that overlap a bin.
class CellLocator {
 public:
  CellLocator() = default;
  /// Convex cells, counter-clockwise. They are not copied and must outlive the object.
  explicit CellLocator(const std::vector<Polygon>& cells);

  /// -1 outside all cells.
  [[nodiscard]] int find(const Point& p) const;

  /// Calls visit(cell) once for each cell whose box overlaps the box from `low` to `high`.
  template <class Visit>
  void each_near(const Point& low, const Point& high, Visit visit) {
    if (bins_.empty()) return;
    ++round_;
    const long i_end = column(high.x());
    const long j_end = row(high.y());
    for (long j = row(low.y()); j <= j_end; ++j) {
      for (long i = column(low.x()); i <= i_end; ++i) {
        for (const int cell : bin(i, j)) {
          if (seen_[static_cast<std::size_t>(cell)] == round_) continue;
          seen_[static_cast<std::size_t>(cell)] = round_;
          visit(cell);
        }
      }
    }
  }

 private:
  [[nodiscard]] long column(double x) const;
  [[nodiscard]] long row(double y) const;
  [[nodiscard]] const std::vector<int>& bin(long i, long j) const {
    return bins_[static_cast<std::size_t>(j * columns_ + i)];
  }

  const std::vector<Polygon>* cells_ = nullptr;
  Point low_ = Point::Zero();
  Point high_ = Point::Zero();
  double width_ = 1;
  double height_ = 1;
  long columns_ = 0;
  long rows_ = 0;
  std::vector<std::vector<int>> bins_;
  std::vector<long> seen_;
  long round_ = 0;
};

}  // namespace blockweir::openfoam
