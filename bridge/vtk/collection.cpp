// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/vtk/collection.hpp"

#include <SMP/Common/vtkSMPToolsAPI.h>
#include <fmt/format.h>
#include <vtkObject.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "bridge/results/result_file.hpp"

namespace blockweir::vtk {

struct Collection::Writer {
  vtkNew<vtkXMLUnstructuredGridWriter> vtk;
};

Collection::Collection(std::filesystem::path folder, const std::string& name)
    : folder_(std::move(folder)),
      list_(folder_ / name, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n",
            "  </Collection>\n</VTKFile>\n"),
      writer_(std::make_unique<Writer>()) {
  std::filesystem::create_directories(folder_ / "frames");
  vtkObject::GlobalWarningDisplayOff();  // failures are reported by add()
  writer_->vtk->SetCompressorTypeToNone();
  // Raw numbers behind the XML would be a quarter shorter, but Debian 12's ParaView 5.11 cannot read files with them
  // that are longer than 4 kB: it feeds them to its XML parser, libexpat 2.5.0-1+deb12u2.
  writer_->vtk->SetDataModeToBinary();
  writer_->vtk->WriteToOutputStringOn();  // a file goes out in one piece, not in a hundred
  // Threads for a few hundred points would only disturb solid and water. Even unused ones ask the system for its number
  // of processors, six times for each file, unless their number is set. VTK's own header for this, vtkSMPTools.h, is
  // not C++20.
  auto& threads = ::vtk::detail::smp::vtkSMPToolsAPI::GetInstance();
  threads.SetBackend("STDThread");
  threads.Initialize(1);
  threads.SetBackend("Sequential");
}

Collection::~Collection() = default;

void Collection::add(const Grid& grid, const std::string& file, double time_s, const char* part, int part_number) {
  const std::string path = (folder_ / "frames" / file).string();
  writer_->vtk->SetInputData(grid.get());
  if (writer_->vtk->Write() == 0 || writer_->vtk->GetErrorCode() != 0) results::cannot_write(path);
  results::write_file(path, writer_->vtk->GetOutputString());
  repeat(file, time_s, part, part_number);
}

void Collection::repeat(const std::string& file, double time_s, const char* part, int part_number) {
  entries_ += fmt::format("    <DataSet timestep=\"{:.9g}\" part=\"{}\" name=\"{}\" file=\"frames/{}\"/>\n", time_s,
                          part_number, part, file);
}

void Collection::save() {
  list_.put(entries_);
}

}  // namespace blockweir::vtk
