// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/stated_loads.hpp"

#include <toml++/toml.h>

namespace blockweir::scene {

namespace {

bool acts(const BaseMotion& motion, double time_s) {
  return motion.acceleration_x_m_per_s2.at(time_s) != 0 || motion.acceleration_y_m_per_s2.at(time_s) != 0;
}

}  // namespace

std::vector<std::string> stated_loads(const Scene& scene) {
  constexpr const char* tables[] = {"point_load", "face_pressure", "line_load",  "body_load",
                                    "silt",       "earthquake",    "base_motion"};
  const toml::table file = toml::parse(scene.text);
  std::vector<std::string> stated;
  for (const char* name : tables) {
    const toml::node* node = file.get(name);
    if (node == nullptr || (node->is_array() && node->as_array()->empty())) continue;
    if (name == std::string("base_motion") && !acts(*scene.base_motion, scene.analysis.duration_s)) continue;
    const std::string table = std::string("[") + name + "]";
    stated.push_back(node->is_array() ? "[" + table + "]" : table);
  }
  return stated;
}

std::map<std::string, double> silt_ice_and_earthquake(const std::string& text) {
  const toml::table file = toml::parse(text);
  std::map<std::string, double> numbers;
  for (const char* name : {"silt", "ice", "earthquake"}) {
    const toml::table* table = file[name].as_table();
    if (table == nullptr) continue;
    for (const auto& [key, node] : *table) {
      if (node.is_number()) numbers[std::string(name) + "." + std::string(key.str())] = *node.value<double>();
    }
  }
  return numbers;
}

std::optional<double> silt_level_m(const std::string& text) {
  return toml::parse(text)["silt"]["level_m"].value<double>();
}

}  // namespace blockweir::scene
