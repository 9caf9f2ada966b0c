// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/own_laws.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

namespace blockweir::scene {

std::vector<std::string> laws_that_state(const std::string& text, const std::string& key) {
  std::vector<std::string> found;
  const toml::table file = toml::parse(text);
  for (const char* list : {"joints", "cut", "joint_set"}) {
    const toml::array* laws = file[list].as_array();
    for (std::size_t i = 0; laws != nullptr && i < laws->size(); ++i) {
      const toml::table* law = (*laws)[i].as_table();
      if (law == nullptr || !law->contains(key)) continue;
      found.push_back(fmt::format("{}.{}", list, (*law)["name"].value<std::string>().value_or(std::to_string(i))));
    }
  }
  return found;
}

}  // namespace blockweir::scene
