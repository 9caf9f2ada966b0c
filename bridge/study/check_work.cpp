// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/check_work.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>

#include "bridge/process/run.hpp"
#include "bridge/process/temporary_folder.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/study/motion_error.hpp"

namespace blockweir::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

StudyTask named_task(const json& item) {
  const fs::path scene = item["scene"].get<std::string>();
  const std::string name = item["study"];
  const scene::Studies studies = scene::read(scene, item["overrides"].get<Settings>()).scene.studies;
  for (const auto& limit : studies.limits) {
    if (limit.name == name) return limit_task(limit);
  }
  for (const auto& order : studies.orders) {
    if (order.name == name) return order_task(order);
  }
  for (const auto& map : studies.maps) {
    if (map.name == name) return map_task(item["brief"].get<bool>() ? thinned(map) : map);
  }
  throw std::runtime_error(
      fmt::format("{}: the scene has no study \"{}\" any more: its file has changed since the command began; start the "
                  "command again",
                  scene.string(), name));
}

json done_study(const json& item) {
  const StudyTask task = named_task(item);
  int count = 0;
  const auto report_run = [&](const std::string& settings, const std::string& outcome) {
    if (item["reported"].get<bool>()) {
      fmt::print(stderr, "{}",
                 results::for_stderr(fmt::format("{}, run {}: {}: {}\n", task.name, ++count, settings, outcome)));
    }
  };
  const StudyResult result = go(task, item["scene"].get<std::string>(), item["overrides"].get<Settings>(), report_run);
  return {{"check", result.check},
          {"runs", result.runs},
          {"text", result.text},
          {"figure", result.figure},
          {"key", result.key}};
}

json done_run(const json& item, const fs::path& folder) {
  const process::RunResult result = process::run({.scene = item["scene"].get<std::string>(),
                                                  .out = folder,
                                                  .variant = item["variant"],
                                                  .overrides = item["overrides"].get<Settings>(),
                                                  .inproc = item.value("inproc", false),
                                                  .quiet = true});
  if (result.exit_code == 130) throw Interrupted();
  json answer = {{"trouble", result.exit_code == 0 ? "" : result.trouble},
                 {"checks", result.summary.value("checks", json::array())},
                 {"wall_time_s", result.summary["wall_time_s"]}};
  if (item.contains("motion") && result.exit_code == 0) {
    answer["energy_gain"] = result.summary["energy_gain"];
    answer["simulated_s"] = result.summary["simulated_s"];
    if (item["motion"].get<bool>()) answer["ways"] = ways_of(result.folder);
  }
  fs::remove_all(result.folder);
  return answer;
}

}  // namespace

json run_item(const fs::path& scene, const std::string& variant, const Settings& overrides) {
  return {{"scene", fs::absolute(scene).string()}, {"variant", variant}, {"overrides", overrides}};
}

json bench_item(const fs::path& scene, const Settings& overrides, bool inproc, bool motion) {
  json item = run_item(scene, "", overrides);
  item["inproc"] = inproc;
  item["motion"] = motion;
  return item;
}

json study_item(const fs::path& scene, const std::string& name, const Settings& overrides, bool brief, bool reported) {
  return {{"scene", fs::absolute(scene).string()},
          {"study", name},
          {"overrides", overrides},
          {"brief", brief},
          {"reported", reported}};
}

StudyResult study_result(const json& answer) {
  StudyResult result;
  if (!answer.is_object()) {
    result.check = {{"name", "none"},       {"expected", nullptr},
                    {"got", nullptr},       {"relative_error", nullptr},
                    {"tolerance", nullptr}, {"passed", false},
                    {"wall_time_s", 0.0},   {"trouble", "its process was killed; see whether memory is short"}};
    return result;
  }
  result.check = answer["check"];
  result.runs = answer["runs"];
  result.text = answer["text"];
  result.figure = answer["figure"];
  result.key = answer["key"];
  return result;
}

engine::Worker check_worker() {
  const auto scratch = std::make_shared<process::TemporaryFolder>();
  return [scratch](const json& item) {
    return item.contains("study") ? done_study(item) : done_run(item, scratch->path() / "run");
  };
}

scene::MapStudy thinned(scene::MapStudy map) {
  for (scene::Sweep& axis : map.axes) {
    const auto& v = axis.values;
    if (v.size() > 3) axis.values = {v.front(), v[v.size() / 2], v.back()};
  }
  return map;
}

void perform_in_order(engine::Engine& engine, const engine::Work& work, const engine::OnAnswer& taken) {
  std::map<std::size_t, json> early;
  std::size_t next = 0;
  const bool all = engine.perform(work, [&](std::size_t i, const json& answer) {
    early[i] = answer;
    for (auto at = early.find(next); at != early.end(); at = early.find(++next)) {
      taken(next, at->second);
      early.erase(at);
    }
  });
  if (!all) throw Interrupted();
}

}  // namespace blockweir::study
