// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/vtk/library/sequential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::vtk {
namespace {

template <class Object>
Object* made() {
  auto* object = new Object;
  object->InitializeObjectBase();
  return object;
}

void begin(double* range) {
  range[0] = std::numeric_limits<double>::max();
  range[1] = std::numeric_limits<double>::lowest();
}

/// Of no values: VTK's reader cannot read back the bounds that a search begins with.
void end(double* range) {
  if (range[0] > range[1]) range[0] = range[1] = 0;
}

/// A value that is no number has no place in a range.
void widen(double* range, double value) {
  range[0] = std::fmin(range[0], value);
  range[1] = std::fmax(range[1], value);
}

}  // namespace

SequentialGrid* SequentialGrid::New() {
  return made<SequentialGrid>();
}

SequentialArray* SequentialArray::New() {
  return made<SequentialArray>();
}

bool SequentialArray::ComputeScalarRange(double* ranges) {
  const int components = GetNumberOfComponents();
  for (int c = 0; c < components; ++c) begin(ranges + 2 * c);
  const double* value = GetPointer(0);
  for (vtkIdType i = 0; i < GetNumberOfTuples(); ++i) {
    for (int c = 0; c < components; ++c) widen(ranges + 2 * c, *value++);
  }
  for (int c = 0; c < components; ++c) end(ranges + 2 * c);
  return true;
}

bool SequentialArray::ComputeVectorRange(double range[2]) {
  const int components = GetNumberOfComponents();
  begin(range);
  const double* value = GetPointer(0);
  for (vtkIdType i = 0; i < GetNumberOfTuples(); ++i) {
    double squares = 0;
    for (int c = 0; c < components; ++c, ++value) squares += *value * *value;
    widen(range, std::sqrt(squares));
  }
  end(range);
  return true;
}

}  // namespace blockweir::vtk
