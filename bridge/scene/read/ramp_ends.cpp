// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/ramp_ends.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

namespace blockweir::scene {
namespace {

void collect(const toml::node& node, const std::string& key, double duration_s, std::vector<std::string>& ends) {
  const auto below = [&](const std::string& name) { return key.empty() ? name : key + "." + name; };
  if (const toml::array* list = node.as_array()) {
    for (std::size_t i = 0; i < list->size(); ++i) collect((*list)[i], below(std::to_string(i)), duration_s, ends);
  }
  const toml::table* table = node.as_table();
  if (table == nullptr) return;
  const auto from = (*table)["from"].value<double>();
  const auto rate = (*table)["rate_per_s"].value<double>();
  if (from && rate && *rate != 0 && !table->contains("to")) {
    ends.push_back(fmt::format("{}={}", below("to"), *from + *rate * duration_s));
  }
  for (const auto& [name, inner] : *table) collect(inner, below(std::string(name.str())), duration_s, ends);
}

}  // namespace

std::vector<std::string> ramp_ends(const Scene& scene) {
  std::vector<std::string> ends;
  collect(toml::parse(scene.text), "", scene.analysis.duration_s, ends);
  return ends;
}

}  // namespace blockweir::scene
