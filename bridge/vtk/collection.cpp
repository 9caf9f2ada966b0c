// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/vtk/collection.hpp"

#include <fmt/format.h>

#include "bridge/results/result_file.hpp"
#include "bridge/results/shared_library.hpp"

namespace blockweir::vtk {

Collection::Collection(std::filesystem::path folder, const std::string& name)
    : folder_(std::move(folder)),
      list_(folder_ / name, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n",
            "  </Collection>\n</VTKFile>\n"),
      xml_(std::async(std::launch::async,
                      [] { return reinterpret_cast<XmlFunction*>(results::symbol_of(xml_library, xml_function)); })) {
  std::filesystem::create_directories(folder_ / "frames");
}

void Collection::add(const Grid& grid, const std::string& file, double time_s, const char* part, int part_number) {
  const std::string path = (folder_ / "frames" / file).string();
  std::string text;
  if (!xml_.get()(grid, text)) results::cannot_write(path);
  results::write_file(path, text);
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
