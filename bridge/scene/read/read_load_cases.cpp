// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/read_load_cases.hpp"

#include <fmt/format.h>

#include "bridge/scene/read/unique_file_names.hpp"

namespace blockweir::scene {

std::vector<LoadCase> read_load_cases(Reading& reading) {
  std::vector<LoadCase> all;
  UniqueFileNames files("load case");
  files.reserve("scene as written");
  reading.each("load_case", [&](TableReader& table) {
    LoadCase load_case{.line = table.place().line};
    table.text("name", load_case.name, true);
    table.text("class", load_case.kind);
    table.texts("set", load_case.set, {}, /*may_be_empty=*/true);
    check_settings(table, reading, load_case.set);
    table.number("required_factor", load_case.required_factor, positive());
    table.text("source", load_case.source);
    if (load_case.required_factor && load_case.source.empty()) {
      reading.problems.error(table.place("required_factor"),
                             fmt::format("{} has a required_factor and no source", table.name()),
                             "the rule or guideline that asks for the factor", "add source = \"...\"");
    }
    if (!table.has("required_factor") && !load_case.source.empty()) {
      reading.problems.error(table.place("source"), fmt::format("{} has a source and no required_factor", table.name()),
                             "both or none", "add required_factor = ..., or leave source out");
    }
    files.add(reading, table, load_case.name);
    all.push_back(std::move(load_case));
  });
  return all;
}

}  // namespace blockweir::scene
