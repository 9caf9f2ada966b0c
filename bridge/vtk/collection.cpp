// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/vtk/collection.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "bridge/results/counted.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/results/shared_library.hpp"

namespace blockweir::vtk {

namespace {

/// Of an entry of the list.
std::string attribute(const std::string& entry, const std::string& name) {
  const std::size_t begin = entry.find(name + "=\"") + name.size() + 2;
  return entry.substr(begin, entry.find('"', begin) - begin);
}

}  // namespace

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
  const std::string entry =
      fmt::format("    <DataSet timestep=\"{:.9g}\" part=\"{}\" name=\"{}\" file=\"frames/{}\"/>\n", time_s,
                  part_number, part, file);
  entries_ += entry;
  listed_ += entry;
}

void Collection::look_for_files() {
  listed_.clear();
  lost_.clear();
  std::set<std::string> missing;
  std::string from_s;
  std::string to_s;
  std::istringstream entries(entries_);
  for (std::string entry; std::getline(entries, entry);) {
    const std::string file = attribute(entry, "file");
    if (std::filesystem::exists(folder_ / file)) {
      listed_ += entry + "\n";
      continue;
    }
    to_s = attribute(entry, "timestep");
    if (missing.empty()) from_s = to_s;
    missing.insert(file);
  }
  if (missing.empty()) return;
  lost_ = fmt::format(
      "frames/ lacks {} that the run had written, of times from {} to {} s: {} to {}; the lists for ParaView leave "
      "them out, and all numbers of the run are right; for those moments put the files back before a resume, or run "
      "the scene anew",
      results::counted(missing.size(), "file"), from_s, to_s, *missing.begin(), *missing.rbegin());
}

void Collection::save() {
  list_.put(listed_);
}

}  // namespace blockweir::vtk
