// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/cell_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::openfoam {
namespace {

constexpr double most_bins = 4e6;

struct Box {
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;
};

Box box_of(const Polygon& polygon) {
  Box box;
  for (const Point& p : polygon) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

bool holds(const Polygon& cell, const Point& p) {
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Point& a = cell[i];
    const Point& b = cell[i + 1 < cell.size() ? i + 1 : 0];
    if ((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x() < 0) return false;
  }
  return true;
}

}  // namespace

CellLocator::CellLocator(const std::vector<Polygon>& cells) : cells_(&cells), seen_(cells.size(), 0) {
  if (cells.empty()) return;
  Box all;
  width_ = height_ = std::numeric_limits<double>::infinity();
  for (const Polygon& cell : cells) {
    const Box box = box_of(cell);
    all.low = all.low.cwiseMin(box.low);
    all.high = all.high.cwiseMax(box.high);
    width_ = std::min(width_, (box.high - box.low).x());
    height_ = std::min(height_, (box.high - box.low).y());
  }
  low_ = all.low;
  high_ = all.high;
  const Point span = high_ - low_;
  const double too_many = std::sqrt(std::max(1.0, span.x() / width_ * (span.y() / height_) / most_bins));
  width_ *= too_many;
  height_ *= too_many;
  columns_ = static_cast<long>(std::ceil(span.x() / width_)) + 1;
  rows_ = static_cast<long>(std::ceil(span.y() / height_)) + 1;
  bins_.resize(static_cast<std::size_t>(columns_ * rows_));
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const Box box = box_of(cells[c]);
    for (long j = row(box.low.y()); j <= row(box.high.y()); ++j) {
      for (long i = column(box.low.x()); i <= column(box.high.x()); ++i) {
        bins_[static_cast<std::size_t>(j * columns_ + i)].push_back(static_cast<int>(c));
      }
    }
  }
}

long CellLocator::column(double x) const {
  return std::clamp(static_cast<long>((x - low_.x()) / width_), 0L, columns_ - 1);
}

long CellLocator::row(double y) const {
  return std::clamp(static_cast<long>((y - low_.y()) / height_), 0L, rows_ - 1);
}

int CellLocator::find(const Point& p) const {
  if (bins_.empty() || (p.array() < low_.array()).any() || (p.array() > high_.array()).any()) return -1;
  for (const int cell : bin(column(p.x()), row(p.y()))) {
    if (holds((*cells_)[static_cast<std::size_t>(cell)], p)) return cell;
  }
  return -1;
}

}  // namespace blockweir::openfoam
