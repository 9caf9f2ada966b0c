// SPDX-License-Identifier: GPL-3.0-or-later
// Points, cells and their data in the plane z = 0, as a VTK unstructured grid has them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace blockweir::vtk {

using Id = std::int64_t;

/// VTK's numbers of its cell types.
enum class Cell : std::uint8_t { vertex = 1, line = 3, triangle = 5, polygon = 7, quadratic_triangle = 22 };

/// Numbers with one tuple for each point or cell.
struct Array {
  std::string name;
  int components = 1;
  std::vector<std::string> component_names{};  ///< empty: without names
  std::vector<double> values{};                ///< tuple by tuple

  void add(double value) { values.push_back(value); }
  void add(std::initializer_list<double> tuple) { values.insert(values.end(), tuple); }
  void add(const Eigen::Vector2d& p) { add({p.x(), p.y(), 0}); }
};

struct Grid {
  Array points{"Points", 3};
  std::vector<Id> corners{};  ///< points of all cells, cell by cell
  std::vector<Id> ends{};     ///< for each cell, the end of its points in `corners`
  std::vector<Cell> types{};
  std::deque<Array> of_points{};
  std::deque<Array> of_cells{};

  Id point(const Eigen::Vector2d& p) {
    points.add(p);
    return static_cast<Id>(points.values.size()) / 3 - 1;
  }
  void cell(Cell type, const std::vector<Id>& ids) {
    corners.insert(corners.end(), ids.begin(), ids.end());
    ends.push_back(static_cast<Id>(corners.size()));
    types.push_back(type);
  }
  /// A new array; the reference holds as long as the grid.
  Array& point_data(std::string name, int components) {
    return of_points.emplace_back(Array{std::move(name), components});
  }
  Array& cell_data(std::string name, int components) {
    return of_cells.emplace_back(Array{std::move(name), components});
  }
};

}  // namespace blockweir::vtk
