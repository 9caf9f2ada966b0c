// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/vtk/xml.hpp"

#include <SMP/Common/vtkSMPToolsAPI.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "bridge/vtk/library/sequential.hpp"

namespace blockweir::vtk {
namespace {

/// On the numbers of `array`, which it does not copy.
vtkNew<SequentialArray> view_of(const Array& array) {
  vtkNew<SequentialArray> view;
  view->SetName(array.name.c_str());
  view->SetNumberOfComponents(array.components);
  for (std::size_t c = 0; c < array.component_names.size(); ++c) {
    view->SetComponentName(static_cast<vtkIdType>(c), array.component_names[c].c_str());
  }
  constexpr int keep = 1;
  view->SetArray(const_cast<double*>(array.values.data()), static_cast<vtkIdType>(array.values.size()), keep);
  return view;
}

vtkNew<SequentialGrid> view_of(const Grid& grid) {
  vtkNew<SequentialGrid> view;
  vtkNew<vtkPoints> points;
  points->SetData(view_of(grid.points));
  view->SetPoints(points);
  for (const Array& array : grid.of_points) view->GetPointData()->AddArray(view_of(array));
  for (const Array& array : grid.of_cells) view->GetCellData()->AddArray(view_of(array));
  const std::vector<vtkIdType> corners(grid.corners.begin(), grid.corners.end());
  Id begin = 0;
  for (std::size_t c = 0; c < grid.types.size(); begin = grid.ends[c], ++c) {
    view->InsertNextCell(static_cast<int>(grid.types[c]), grid.ends[c] - begin, corners.data() + begin);
  }
  return view;
}

vtkNew<vtkXMLUnstructuredGridWriter> make_writer() {
  vtkObject::GlobalWarningDisplayOff();  // failures are reported by the caller
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetCompressorTypeToNone();
  // Raw numbers behind the XML would be a quarter shorter, but Debian 12's ParaView 5.11 cannot read files with them
  // that are longer than 4 kB: it feeds them to its XML parser, libexpat 2.5.0-1+deb12u2.
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();  // a file goes out in one piece, not in a hundred
  // Threads for a few hundred points would only disturb solid and water. Even unused ones ask the system for its number
  // of processors, six times for each file, unless their number is set. VTK's own header for this, vtkSMPTools.h, is
  // not C++20.
  auto& threads = ::vtk::detail::smp::vtkSMPToolsAPI::GetInstance();
  threads.SetBackend("STDThread");
  threads.Initialize(1);
  threads.SetBackend("Sequential");
  return writer;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) bool blockweir_vtk_xml(const Grid& grid, std::string& text) {
  static const vtkNew<vtkXMLUnstructuredGridWriter> writer = make_writer();
  const vtkNew<SequentialGrid> view = view_of(grid);
  writer->SetInputData(view);
  const bool written = writer->Write() != 0 && writer->GetErrorCode() == 0;
  if (written) text = writer->GetOutputString();
  writer->SetInputData(nullptr);  // the view ends with this call
  return written;
}

}  // namespace blockweir::vtk
