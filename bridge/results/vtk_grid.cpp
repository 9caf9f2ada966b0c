// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/results/vtk_grid.hpp"

#include <vtkCellData.h>
#include <vtkPointData.h>

namespace blockweir::results {
namespace {

vtkDoubleArray* array(vtkDataSetAttributes* owner, const char* name, int components) {
  vtkNew<vtkDoubleArray> data;
  data->SetName(name);
  data->SetNumberOfComponents(components);
  owner->AddArray(data);
  return data;
}

}  // namespace

VtkGrid::VtkGrid() {
  points_->SetDataTypeToDouble();
  grid_->SetPoints(points_);
}

vtkDoubleArray* VtkGrid::point_data(const char* name, int components) {
  return array(grid_->GetPointData(), name, components);
}

vtkDoubleArray* VtkGrid::cell_data(const char* name, int components) {
  return array(grid_->GetCellData(), name, components);
}

}  // namespace blockweir::results
