// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// bridge/scene/KEYS.md says of each key what the reader does: its name, its unit, its default, whether it is required.
// Long, as the page is parsed here, and every section needs a sound scene to which its keys are added.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "bridge/scene/read/read.hpp"
#include "tests/scenes_of_tables.hpp"

namespace blockweir::scene::documented_keys_test {
namespace {

using test::scene_with;

struct Key {
  std::string name;
  std::string unit;
  std::string standard;  ///< the cell of its default
};

using Tables = std::map<std::string, std::vector<Key>>;

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream stream(row);
  for (std::string cell; std::getline(stream, cell, '|');) {
    const auto from = cell.find_first_not_of(' ');
    cells.push_back(from == std::string::npos ? "" : cell.substr(from, cell.find_last_not_of(' ') - from + 1));
  }
  return cells;
}

/// The tables under headings like ### `[[block]]`.
Tables documented() {
  Tables tables;
  std::ifstream page(std::string(BLOCKWEIR_SOURCE) + "/bridge/scene/KEYS.md");
  const std::regex heading("### `\\[+([a-zA-Z_.]+)\\]+`");
  const std::regex quoted("`([^`]+)`");
  std::string table;
  bool of_keys = false;
  for (std::string line; std::getline(page, line);) {
    std::smatch found;
    if (line.starts_with("#")) table = std::regex_match(line, found, heading) ? found[1].str() : "";
    if (!line.starts_with("|")) of_keys = false;
    if (line == "| key | unit | default | meaning |") of_keys = true;
    if (table.empty() || !of_keys || !line.starts_with("| `")) continue;
    const std::vector<std::string> cells = cells_of(line);
    for (std::sregex_iterator i(cells[1].begin(), cells[1].end(), quoted), end; i != end; ++i) {
      tables[table].push_back({(*i)[1], cells.at(2), cells.at(3)});
    }
  }
  for (const char* other : {"joints", "cut", "joint_set"}) {
    for (const Key& key : tables["joint"]) tables[other].push_back({key.name, key.unit, "as in [joint]"});
  }
  return tables;
}

toml::table& table_of(toml::table& file, const std::string& name) {
  if (name == "material.NAME") return *file["material"]["m"].as_table();
  if (const auto dot = name.find('.'); dot != std::string::npos) {
    return *file[name.substr(0, dot)][name.substr(dot + 1)].as_table();
  }
  toml::node& node = *file.get(name);
  return node.is_array() ? *node.as_array()->get(0)->as_table() : *node.as_table();
}

std::string text_of(const toml::table& file) {
  std::ostringstream text;
  text << file << '\n';
  return text.str();
}

/// What the reader finds wrong.
std::vector<Diagnostic> problems_of(const std::string& text) {
  try {
    read_text(text, "scene.toml");
    return {};
  } catch (const SceneError& error) {
    return error.diagnostics();
  }
}

bool found(const std::vector<Diagnostic>& problems, const std::string& words) {
  return std::any_of(problems.begin(), problems.end(),
                     [&](const Diagnostic& d) { return d.found.find(words) != std::string::npos; });
}

/// What `key=value` makes of the scene; none where it is refused. Without what any text would change.
std::optional<std::tuple<Scene, std::vector<OpenStudy>, Randomness>> scene_of(const std::string& text,
                                                                              const std::string& table,
                                                                              const std::string& key,
                                                                              const std::string& value) {
  std::string path = table == "material.NAME" ? "material.m" : table;
  toml::table file = toml::parse(text);
  if (table.find('.') == std::string::npos && file.get(table)->is_array()) path += ".0";
  std::vector<std::string> overrides;
  if (!value.empty()) overrides.push_back(fmt::format("{}.{}={}", path, key, value));
  try {
    auto [scene, load_cases, open_studies, randomness, notes, warnings] = read_text(text, "scene.toml", overrides);
    scene.text.clear();
    scene.digest.clear();
    scene.warnings.clear();
    return std::tuple{scene, open_studies, randomness};
  } catch (const SceneError&) {
    return std::nullopt;
  }
}

/// Another value than `literal`; empty where no other is known to be sound.
std::string other_than(const std::string& literal) {
  if (literal == "true") return "false";
  if (literal == "false") return "true";
  if (literal == "[0, 0]") return "[0.5, 0.5]";
  if (literal.find_first_of("\"[") != std::string::npos) return "";
  return literal.find_first_of(".e") == std::string::npos ? std::to_string(std::stoi(literal) + 1)
                                                          : fmt::format("{}", std::stod(literal) * 0.5);
}

TEST(DocumentedKeys, TheScenesOfThisTestAreSound) {
  for (const auto& [table, keys] : documented()) {
    for (const Diagnostic& problem : problems_of(scene_with(table))) ADD_FAILURE() << table << ": " << problem.text();
  }
}

/// How many keys a message lists: "a, b, c and 2 more".
std::size_t listed(const std::string& keys) {
  std::size_t known = 1 + static_cast<std::size_t>(std::count(keys.begin(), keys.end(), ','));
  if (const auto more = keys.find(" and "); more != std::string::npos) known += std::stoul(keys.substr(more + 5));
  return known;
}

/// A key that does not exist is answered with those that do.
TEST(DocumentedKeys, AreThoseThatTheReaderReads) {
  const Tables tables = documented();
  EXPECT_GE(tables.size(), 36U);
  for (const auto& [table, keys] : tables) {
    toml::table file = toml::parse(scene_with(table));
    toml::table& read = table_of(file, table);
    for (const Key& key : keys) {
      if (!read.contains(key.name)) read.insert(key.name, toml::date{2000, 1, 1});  // wrong for every key
    }
    read.insert("zzzzzzzz", 1);
    int unknown = 0;
    for (const Diagnostic& problem : problems_of(text_of(file))) {
      if (!problem.found.starts_with("unknown key")) continue;
      ++unknown;
      EXPECT_THAT(problem.found, testing::HasSubstr("zzzzzzzz")) << "in no reader";
      EXPECT_EQ(listed(problem.expected), keys.size())
          << table << " is documented with another number of keys: " << problem.expected;
    }
    EXPECT_EQ(unknown, 1) << table;
  }
}

/// The list after "unknown key" is complete, whichever of its keys the table states.
TEST(DocumentedKeys, AreAllListedBesideAnUnknownOne) {
  for (const auto& [table, keys] : documented()) {
    toml::table file = toml::parse(scene_with(table));
    table_of(file, table).insert("zzzzzzzz", 1);
    for (const Diagnostic& problem : problems_of(text_of(file))) {
      if (problem.found.starts_with("unknown key"))
        EXPECT_EQ(listed(problem.expected), keys.size()) << table << ": " << problem.expected;
    }
  }
}

TEST(DocumentedKeys, HaveTheUnitOfTheirName) {
  std::set<std::string> endings;
  const auto ending = [](std::string unit) {
    std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
    unit = unit == "1/s" ? "per_s" : std::regex_replace(unit, std::regex("/"), "_per_");
    std::replace(unit.begin(), unit.end(), ' ', '_');
    return "_" + unit;
  };
  const Tables tables = documented();
  for (const auto& [table, keys] : tables) {
    for (const Key& key : keys) {
      if (!key.unit.empty() && key.unit != "1") endings.insert(ending(key.unit));
    }
  }
  for (const auto& [table, keys] : tables) {
    for (const Key& key : keys) {
      std::string longest;
      for (const std::string& unit : endings) {
        if (key.name.ends_with(unit) && unit.size() > longest.size()) longest = unit;
      }
      EXPECT_EQ(longest, key.unit.empty() || key.unit == "1" ? "" : ending(key.unit)) << table << ": " << key.name;
    }
  }
}

TEST(DocumentedKeys, AreRequiredWhereThePageSaysSo) {
  for (const auto& [table, keys] : documented()) {
    for (const Key& key : keys) {
      toml::table file = toml::parse(scene_with(table));
      table_of(file, table).erase(key.name);
      EXPECT_EQ(found(problems_of(text_of(file)), fmt::format("has no \"{}\"", key.name)),
                key.standard.starts_with("required"))
          << table << ": " << key.name;
    }
  }
}

TEST(DocumentedKeys, HaveTheDefaultsThatThePageSays) {
  int compared = 0;
  for (const auto& [table, keys] : documented()) {
    for (const Key& key : keys) {
      std::smatch literal;
      if (!std::regex_match(key.standard, literal, std::regex("`([^`]+)`"))) continue;
      toml::table file = toml::parse(scene_with(table));
      table_of(file, table).erase(key.name);
      const std::string text = text_of(file);
      const auto without = scene_of(text, table, key.name, "");
      const auto with = scene_of(text, table, key.name, literal[1]);
      ASSERT_TRUE(without) << table << ": " << key.name;
      EXPECT_TRUE(with == without) << table << ": " << key.name << " is by default not " << literal[1];
      ++compared;
      const std::string other = other_than(literal[1]);
      if (other.empty()) continue;
      EXPECT_FALSE(scene_of(text, table, key.name, other) == without) << table << ": " << key.name << " has no effect";
    }
  }
  EXPECT_GE(compared, 80);
}

}  // namespace
}  // namespace blockweir::scene::documented_keys_test
