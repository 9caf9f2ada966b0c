// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/vtk/grid.hpp"

#include <vtkCellData.h>
#include <vtkPointData.h>

namespace blockweir::vtk {
namespace {

vtkDoubleArray* array(vtkDataSetAttributes* owner, const char* name, int components) {
  vtkNew<SequentialArray> data;
  data->SetName(name);
  data->SetNumberOfComponents(components);
  owner->AddArray(data);
  return data;
}

}  // namespace

Grid::Grid() {
  vtkNew<SequentialArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  points_->SetData(coordinates);
  grid_->SetPoints(points_);
}

vtkDoubleArray* Grid::point_data(const char* name, int components) {
  return array(grid_->GetPointData(), name, components);
}

vtkDoubleArray* Grid::cell_data(const char* name, int components) {
  return array(grid_->GetCellData(), name, components);
}

}  // namespace blockweir::vtk
