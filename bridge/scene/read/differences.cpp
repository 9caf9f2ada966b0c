// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/differences.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "bridge/results/counted.hpp"
#include "bridge/scene/read/overrides.hpp"

namespace blockweir::scene {
namespace {

using Values = std::map<std::string, std::string>;

/// Numbers in as few digits as say the same.
std::string text_of(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const toml::array* list = node.as_array()) {
    std::vector<std::string> texts;
    for (const toml::node& entry : *list) texts.push_back(text_of(entry));
    return fmt::format("[{}]", fmt::join(texts, ", "));
  }
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

/// Texts of all values by key. Entries of a list are called by their names, or else by their number.
void collect(const toml::node& node, const std::string& key, Values& into) {
  const auto below = [&](const std::string& name) { return key.empty() ? name : key + "." + name; };
  const toml::array* list = node.as_array();
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, value] : *table) collect(value, below(std::string(name.str())), into);
  } else if (list != nullptr && list->is_array_of_tables()) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      const auto name = (*(*list)[i].as_table())["name"].value<std::string>();
      collect((*list)[i], below(name.value_or(std::to_string(i))), into);
    }
  } else {
    into[key] = text_of(node);
  }
}

std::string shortened(const std::string& value) {
  constexpr std::size_t shown = 40;
  return value.size() <= shown ? value : value.substr(0, shown - 3) + "...";
}

}  // namespace

std::vector<Difference> differences(const std::string& before, const std::string& now) {
  Values values_before;
  Values values_now;
  try {
    collect(toml::parse(before), "", values_before);
    collect(toml::parse(now), "", values_now);
  } catch (const toml::parse_error&) {
    return {{"", "unreadable", "unreadable"}};
  }
  std::map<std::string, Difference> found;
  const auto value_in = [](const Values& values, const std::string& key) {
    const auto at = values.find(key);
    return at == values.end() ? "none" : at->second;
  };
  for (const Values* values : {&values_before, &values_now}) {
    for (const auto& [key, value] : *values) {
      const Difference both{key, value_in(values_before, key), value_in(values_now, key)};
      if (both.before != both.now) found[key] = both;
    }
  }
  std::vector<Difference> list;
  for (const auto& [key, difference] : found) list.push_back(difference);
  return list;
}

std::string differences_text(const std::string& before, const std::string& now,
                             const std::vector<std::string>& overrides) {
  constexpr std::size_t most = 3;
  const std::vector<Difference> found = differences(before, now);
  if (found.empty()) return "its file differs in comments or layout alone";
  if (found.front().key.empty()) return "its scene.toml is not readable";
  const toml::table file = toml::parse(now);
  const auto is_set = [&](const std::string& key) {
    return std::any_of(overrides.begin(), overrides.end(), [&](const std::string& argument) {
      const std::string set = plain_key(file, setting_key(argument));
      const std::string plain = plain_key(file, key);
      return plain == set || plain.starts_with(set + ".");
    });
  };
  std::string text;
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i) {
    text += fmt::format("{}{} is {} there and {} here{}", i == 0 ? "" : ", ", found[i].key, shortened(found[i].before),
                        shortened(found[i].now), is_set(found[i].key) ? " (--set)" : "");
  }
  return found.size() <= most ? text
                              : fmt::format("{}, and {}", text, results::counted(found.size() - most, "more key"));
}

}  // namespace blockweir::scene
