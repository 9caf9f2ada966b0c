// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the sections of a scene file, and unknown ones.
#include "bridge/scene/read/reading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/scene/read/key_homes.hpp"
#include "bridge/scene/read/nearest.hpp"

namespace blockweir::scene {

const toml::table* Reading::section(const char* name) {
  sections.emplace_back(name);
  const toml::node* node = file.get(name);
  if (node != nullptr && !node->is_table()) {
    problems.error(problems.at(node->source()), fmt::format("{} is not a section", name), fmt::format("[{}]", name),
                   fmt::format("write its keys under a line [{}]", name));
  }
  return node != nullptr ? node->as_table() : nullptr;
}

std::vector<const toml::table*> Reading::entries(const char* name) {
  sections.emplace_back(name);
  const toml::node* node = file.get(name);
  if (node == nullptr) return {};
  const toml::array* list = node->as_array();
  if (list == nullptr || (!list->empty() && !list->is_array_of_tables())) {
    problems.error(problems.at(node->source()), fmt::format("{} is not a list of sections", name),
                   fmt::format("[[{}]]", name), fmt::format("write each one under a line [[{}]]", name));
    return {};
  }
  std::vector<const toml::table*> tables;
  for (const auto& entry : *list) tables.push_back(entry.as_table());
  return tables;
}

std::string Reading::entry_name(const char* name, const toml::table& table) {
  const auto own = table["name"].value<std::string>();
  return own ? fmt::format("[[{}]] \"{}\"", name, *own) : fmt::format("[[{}]]", name);
}

const Block* Reading::sound_block(int index) const {
  if (index < 0) return nullptr;
  const Block& block = scene.blocks[static_cast<std::size_t>(index)];
  return block.vertices.empty() ? nullptr : &block;
}

void refuse_second(Reading& reading, const Place& place, const char* kind, const std::string& name,
                   std::initializer_list<const char*> sections) {
  int first = 0;
  for (const char* section : sections) {
    const toml::array* list = reading.file[section].as_array();
    if (list == nullptr) continue;
    for (const toml::node& node : *list) {
      if (!node.is_table() || (*node.as_table())["name"].value<std::string>() != name) continue;
      const int line = static_cast<int>(node.source().begin.line);
      first = first == 0 ? line : std::min(first, line);
    }
  }
  reading.problems.error(place,
                         fmt::format("a second {} is called \"{}\"{}", kind, name,
                                     first > 0 ? fmt::format(", as that of line {}", first) : ""),
                         "names that differ", "rename one of them");
}

void refuse_repeated_names(Reading& reading) {
  for (const auto& [section, kind] : {std::pair{"region", "region"}, {"cut", "cut"}, {"joint_set", "joint set"}}) {
    Names names(kind);
    const toml::array* list = reading.file[section].as_array();
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
      const toml::table* table = (*list)[i].as_table();
      const auto name = table == nullptr ? std::nullopt : (*table)["name"].value<std::string>();
      if (!name || name->empty() || names.add(*name)) continue;
      if ((*table)["drawn"].value<bool>().value_or(false)) continue;  // lines on one layer, of one law
      refuse_second(reading, reading.problems.at(table->get("name")->source()), kind, *name, {section});
    }
  }
}

void read_heading(Reading& reading) {
  for (auto [key, into] : {std::pair{"title", &reading.scene.title}, std::pair{"note", &reading.scene.note}}) {
    reading.sections.emplace_back(key);
    const toml::node* node = reading.file.get(key);
    if (node == nullptr) continue;
    const auto text = node->is_string() ? node->value<std::string>() : std::nullopt;
    if (text) {
      *into = *text;
    } else {
      reading.problems.error(reading.problems.at(node->source()), fmt::format("{} is not a text", key),
                             "a text in quotes", fmt::format("put the {} in quotes", key));
    }
  }
}

void reject_unknown_sections(Reading& reading) {
  for (const auto& [key, node] : reading.file) {
    const std::string word(key.str());
    const auto& known = reading.sections;
    if (reading.problems.full()) return;
    if (std::find(known.begin(), known.end(), word) != known.end()) continue;
    const std::string home = home_advice(word);
    reading.problems.error(reading.problems.at(key.source()),
                           fmt::format("unknown {} \"{}\"", node.is_value() ? "key" : "section", word), one_of(known),
                           home.empty() ? did_you_mean(word, known) : home);
  }
}

}  // namespace blockweir::scene
