// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of a load case, variant or study that contradict each other, of two for one key the last would count, or
// that are of no effect.
#include <fmt/format.h>

#include <map>

#include "bridge/scene/read/overrides.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

void check_settings(TableReader& table, Reading& reading, const std::vector<std::string>& set,
                    const std::vector<std::string>& own_keys) {
  std::map<std::string, std::string> first;
  const auto require_of_scene = [&](const char* place, const char* how, const std::string& setting) {
    const std::string key = setting_key(setting);
    const std::string section = key.substr(0, key.find('.'));
    if (!is_of_whole_file(section)) return;
    reading.problems.error(table.place(place), fmt::format("{} {} \"{}\"", table.name(), how, setting),
                           "keys of the scene itself, not of its variants and studies",
                           fmt::format("change [[{}]] where it is written", section));
  };
  for (const std::string& setting : set) {
    require_of_scene("set", "sets", setting);
    const auto [other, is_new] = first.emplace(plain_key(reading.file, setting_key(setting)), setting);
    if (is_new) continue;
    reading.problems.error(table.place("set"),
                           fmt::format("set in {} has \"{}\" and \"{}\"", table.name(), other->second, setting),
                           "each key once", "leave one of them out");
  }
  for (const std::string& key : own_keys) {
    if (key.empty()) continue;
    require_of_scene("name", "varies", key);
    const auto [other, is_new] = first.emplace(plain_key(reading.file, key), key);
    if (is_new) continue;
    reading.problems.error(
        table.place(table.has("set") ? "set" : "name"),
        fmt::format("{} varies \"{}\", and states \"{}\" beside it", table.name(), key, other->second), "each key once",
        "leave one of them out");
  }
}

}  // namespace blockweir::scene
