// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/validate/stress.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/results/counted.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/result_file.hpp"
#include "bridge/scene/read/nearest.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/check_work.hpp"
#include "bridge/study/engines.hpp"
#include "bridge/study/study.hpp"
#include "bridge/validate/cases_folder.hpp"
#include "bridge/validate/table_line.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<fs::path> all_scenes() {
  std::vector<fs::path> scenes;
  for (const auto& entry : fs::directory_iterator(cases_folder() / "stress")) {
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

fs::path chosen(const std::string& name) {
  if (fs::exists(name)) return name;
  std::vector<std::string> names;
  for (const fs::path& scene : all_scenes()) {
    if (scene.stem() == name) return scene;
    names.push_back(scene.stem());
  }
  const std::string near = scene::nearest(name, names);
  throw std::invalid_argument(fmt::format("no scene and no stress map is called \"{}\"; the maps are {}{}", name,
                                          scene::one_of(names),
                                          near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near)));
}

struct Map {
  fs::path scene;
  StudyTask task;
};

/// Each is read and checked before any runs.
std::vector<Map> maps_of(const fs::path& scene, bool brief) {
  std::vector<Map> maps;
  for (scene::MapStudy map : scene::read(scene).scene.studies.maps) {
    maps.push_back({scene, map_task(brief ? thinned(map) : map)});
    for (const Settings& cell : maps.back().task.extremes) require_sound(maps.back().task, scene, {}, cell);
  }
  if (maps.empty())
    throw std::invalid_argument(
        fmt::format("{}: found no [[map]]; expected a scene with one; add one, or name another scene", scene.string()));
  return maps;
}

json row(const Map& map, const StudyResult& result) {
  json row = {{"scene", map.scene.stem()}, {"map", map.task.name}, {"cells", result.runs.size()}};
  for (const char* key : {"passed", "right", "refused", "got", "trouble", "wall_time_s"}) {
    if (result.check.contains(key)) row[key] = result.check[key];
  }
  row["runs"] = result.runs;
  return row;
}

void print(const json& rows) {
  fmt::print("\n{}", table_line("map", fmt::format("{:>6} {:>6} {:>8} {:>6} {:>9}    ", "cells", "right", "refused",
                                                   "wrong", "time s")));
  for (const json& row : rows) {
    fmt::print("{}", table_line(row["map"],
                                fmt::format("{:>6} {:>6} {:>8} {:>6} {:>9.3g} {:<3}", row["cells"].get<int>(),
                                            row.value("right", 0), row.value("refused", 0), row.value("got", 0),
                                            row["wall_time_s"].get<double>(), row["passed"].get<bool>() ? "" : "OUT")));
  }
}

}  // namespace

int stress(const StressOptions& options) {
  std::vector<fs::path> scenes;
  for (const std::string& name : options.names) scenes.push_back(chosen(name));
  if (scenes.empty()) scenes = all_scenes();
  std::vector<Map> maps;
  for (const fs::path& scene : scenes) {
    for (Map& map : maps_of(scene, options.brief)) maps.push_back(std::move(map));
  }
  json rows = json::array();
  try {
    engine::Work work{.name = "stress", .common = {{"by", "check"}}, .items = {}};
    for (const Map& map : maps) {
      work.items.push_back(study_item(map.scene, map.task.name, {}, options.brief, /*reported=*/true));
    }
    results::make_folder(options.out);
    perform_in_order(*make_engine(options.engine, options.out), work, [&](std::size_t i, const json& answer) {
      const StudyResult result = study_result(answer);
      const fs::path out = options.out / maps[i].scene.stem();
      results::make_folder(out);
      print_study(maps[i].task.name, result, out);
      rows.push_back(row(maps[i], result));
    });
  } catch (const Interrupted&) {
    fmt::print(stderr, "stopped on request\n");
    return 130;
  }
  print(rows);
  const fs::path table = options.out / "stress.json";
  results::replace_file(table, rows.dump(2) + "\n");
  const bool sound = std::all_of(rows.begin(), rows.end(), [](const json& r) { return r["passed"].get<bool>(); });
  fmt::print("{}, {}; {}\n", results::counted(rows.size(), "map"), sound ? "no cell is wrong" : "cells are WRONG",
             table.string());
  return sound ? 0 : 1;
}

}  // namespace blockweir::study
