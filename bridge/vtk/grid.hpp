// SPDX-License-Identifier: GPL-3.0-or-later
// A VTK unstructured grid under construction, in the plane z = 0.
#pragma once

#include <vtkNew.h>
#include <vtkPoints.h>

#include <Eigen/Core>
#include <vector>

#include "bridge/vtk/sequential.hpp"

namespace blockweir::vtk {

class Grid {
 public:
  Grid();
  vtkIdType point(const Eigen::Vector2d& p) { return points_->InsertNextPoint(p.x(), p.y(), 0); }
  void cell(int type, const std::vector<vtkIdType>& ids) {
    grid_->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  }
  /// A new array of the grid with one tuple for each point or cell.
  vtkDoubleArray* point_data(const char* name, int components);
  vtkDoubleArray* cell_data(const char* name, int components);
  [[nodiscard]] vtkUnstructuredGrid* get() const { return grid_; }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<SequentialGrid> grid_;
};

inline void add_vector(vtkDoubleArray* data, const Eigen::Vector2d& p) {
  data->InsertNextTuple3(p.x(), p.y(), 0);
}

}  // namespace blockweir::vtk
