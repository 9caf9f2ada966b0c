// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/unique_file_names.hpp"

#include <fmt/format.h>

#include "bridge/results/file_name.hpp"

namespace blockweir::scene {

void UniqueFileNames::reserve(const std::string& name) {
  owners_.emplace(results::file_name(name), Owner{});
}

void UniqueFileNames::take(const std::string& name, int line) {
  owners_.emplace(results::file_name(name), Owner{name, line});
}

void UniqueFileNames::add(Reading& reading, const TableReader& table, const std::string& name) {
  if (name.empty()) return;
  const Place place = table.place("name");
  const std::string file = results::file_name(name);
  const auto [owner, is_new] = owners_.emplace(file, Owner{name, place.line});
  if (is_new) return;
  const auto& [other, line] = owner->second;
  const std::string where = line > 0 ? fmt::format(" of line {}", line) : "";
  if (other.empty()) {
    reading.problems.error(place, fmt::format("a {} is called \"{}\", which is the program's own", kind_, name),
                           "another name", "rename it");
  } else if (other == name) {
    reading.problems.error(place, fmt::format("a second {} is called \"{}\", as that{}", kind_, name, where),
                           "names that differ", "rename one of them");
  } else {
    reading.problems.error(
        place,
        fmt::format("the {0} \"{1}\" would write to the files of the {0} \"{2}\"{3}, which are called \"{4}\"", kind_,
                    name, other, where, file),
        "names that differ in letters or digits", "rename one of them");
  }
}

}  // namespace blockweir::scene
