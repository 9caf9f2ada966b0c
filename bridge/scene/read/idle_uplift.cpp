// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/idle_uplift.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/uplift.hpp"

namespace blockweir::scene {
namespace {

constexpr std::array drains = {"drain_m", "drain_efficiency", "drain_head_m"};
constexpr std::array piezometers = {"piezometers_m", "piezometers_level_m"};

bool is_set(const toml::node& node, const Problems& problems) {
  return problems.at(node.source()).line == 0;
}

/// The law that a table states by --set; none if it states none, or another way.
std::optional<Uplift> law_set_in(const toml::table& table, const Problems& problems) {
  const toml::node* node = table.get("uplift");
  if (node == nullptr || !is_set(*node, problems)) return std::nullopt;
  const auto word = node->value<std::string>();
  const auto* found = std::find_if(uplift_names.begin(), uplift_names.end(),
                                   [&](const UpliftName& name) { return word && *word == name.name; });
  if (found == uplift_names.end()) return std::nullopt;
  return found->law;
}

void leave_out(toml::table& table, const std::string& name, Uplift law, Problems& problems) {
  const auto leave = [&](const auto& keys, const char* laws) {
    Place place;
    std::vector<std::string> left;
    for (const char* key : keys) {
      const toml::node* node = table.get(key);
      if (node == nullptr || is_set(*node, problems)) continue;
      if (left.empty()) place = problems.at(node->source());
      left.emplace_back(key);
      table.erase(key);
    }
    if (left.empty()) return;
    problems.warning(place,
                     fmt::format("{} in {} {} no effect: its uplift is set to \"{}\"", fmt::join(left, " and "), name,
                                 left.size() == 1 ? "has" : "have", named(law).name),
                     fmt::format("uplift = {} where they are to count", laws),
                     "where they are not, nothing is to be done");
  };
  if (law != Uplift::drained && law != Uplift::cracked) leave(drains, "\"drained\" or \"cracked\"");
  if (law != Uplift::heads) leave(piezometers, "\"heads\"");
}

}  // namespace

void leave_out_idle_uplift(toml::table& file, Problems& problems) {
  toml::table* joint = file["joint"].as_table();
  const auto of_all = joint != nullptr ? law_set_in(*joint, problems) : std::nullopt;
  if (of_all) leave_out(*joint, "[joint]", *of_all, problems);
  for (auto&& [section, node] : file) {
    toml::array* entries = node.as_array();
    if (entries == nullptr) continue;
    for (toml::node& entry : *entries) {
      toml::table* table = entry.as_table();
      if (table == nullptr) continue;
      const auto law = table->contains("uplift") ? law_set_in(*table, problems) : of_all;
      const std::string name = fmt::format("[[{}]] \"{}\"", section.str(), (*table)["name"].value_or(std::string()));
      if (law) leave_out(*table, name, *law, problems);
    }
  }
}

}  // namespace blockweir::scene
