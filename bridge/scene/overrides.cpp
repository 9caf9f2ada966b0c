// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace blockweir::scene {
namespace {

toml::table parse_value(const std::string& value) {
  try {
    return toml::parse("value = " + value);
  } catch (const toml::parse_error&) {
    toml::table bare;
    bare.insert("value", value);
    return bare;
  }
}

toml::table* entry(toml::array& list, const std::string& word) {
  for (auto& node : list) {
    toml::table* table = node.as_table();
    if (table != nullptr && (*table)["name"].value<std::string>() == word) return table;
  }
  if (word.empty() || word.size() > 9 || word.find_first_not_of("0123456789") != std::string::npos) return nullptr;
  const auto index = static_cast<std::size_t>(std::stoul(word));
  return index < list.size() ? list[index].as_table() : nullptr;
}

/// The table that holds the last word of the path; sections that are absent are made.
toml::table* descend(toml::table& file, const std::vector<std::string>& path) {
  toml::table* here = &file;
  for (std::size_t i = 0; here != nullptr && i + 1 < path.size(); ++i) {
    toml::node* next = here->get(path[i]);
    if (next == nullptr) next = &here->insert(path[i], toml::table{}).first->second;
    if (toml::array* list = next->as_array(); list != nullptr && i + 2 < path.size()) {
      here = entry(*list, path[++i]);
    } else {
      here = next->as_table();
    }
  }
  return here;
}

}  // namespace

void apply_overrides(toml::table& file, const std::vector<std::string>& overrides, Problems& problems) {
  for (const std::string& override : overrides) {
    const auto equals = override.find('=');
    std::vector<std::string> path;
    std::istringstream words(override.substr(0, equals));
    for (std::string word; std::getline(words, word, '.');) path.push_back(word);
    const bool sound = equals != std::string::npos && !path.empty() &&
                       std::none_of(path.begin(), path.end(), [](const auto& word) { return word.empty(); });
    toml::table* table = sound ? descend(file, path) : nullptr;
    if (table == nullptr) {
      problems.error(0, fmt::format("--set {} names nothing in the scene", override), "section.key=value",
                     "write for example --set analysis.step_s=0.001 or --set block.top.fixed=true");
      continue;
    }
    table->insert_or_assign(path.back(), *parse_value(override.substr(equals + 1)).get("value"));
  }
}

}  // namespace blockweir::scene
