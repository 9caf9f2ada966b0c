// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's grid and array with sequential loops over cells and values. VTK's own loops prepare for threads each time: 2 %
// of the instructions of a small scene's run.
#pragma once

#include <vtkDoubleArray.h>
#include <vtkUnstructuredGrid.h>

namespace blockweir::vtk {

class SequentialGrid : public vtkUnstructuredGrid {
 public:
  static SequentialGrid* New();
  void GetCellTypes(vtkCellTypes* types) override { vtkDataSet::GetCellTypes(types); }
};

class SequentialArray : public vtkDoubleArray {
 public:
  static SequentialArray* New();

 protected:
  /// ranges: smallest and largest value of each component in turn.
  bool ComputeScalarRange(double* ranges) override;
  /// Smallest and largest length of a tuple.
  bool ComputeVectorRange(double range[2]) override;
};

}  // namespace blockweir::vtk
