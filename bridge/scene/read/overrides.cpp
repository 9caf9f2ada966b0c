// SPDX-License-Identifier: GPL-3.0-or-later
// Values that the command line sets over those of the file: --set analysis.step_s=0.001.
#include "bridge/scene/read/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <charconv>
#include <memory>
#include <sstream>

#include "bridge/scene/read/nearest.hpp"

namespace blockweir::scene {
namespace {

constexpr std::size_t longest_path = 20;

/// One "dotted.key=value". Its place in messages is the argument itself.
struct Override {
  std::string argument;
  std::vector<std::string> path;
  std::string value;
};

Override split(const std::string& argument) {
  Override split{.argument = override_place(argument)};
  const auto equals = argument.find('=');
  if (equals == std::string::npos) return split;
  std::istringstream words(setting_key(argument));
  for (std::string word; std::getline(words, word, '.');) split.path.push_back(word);
  split.value = boost::trim_copy(argument.substr(equals + 1));
  return split;
}

/// Has a section an entry, or a table, of this name?
bool names_one(const toml::node& section, const std::string& name) {
  if (const toml::table* table = section.as_table()) return (*table)[name].is_table();
  const toml::array* list = section.as_array();
  return list != nullptr && std::any_of(list->begin(), list->end(), [&](const toml::node& node) {
           return node.is_table() && (*node.as_table())["name"].value<std::string>() == name;
         });
}

/// Names may have dots: words that are together a name become one.
Override split(const toml::table& file, const std::string& argument) {
  Override o = split(argument);
  const toml::node* section = o.path.empty() ? nullptr : file.get(o.path.front());
  if (section == nullptr) return o;
  const auto first = o.path.begin() + 1;
  for (auto end = o.path.end(); end - first > 2;) {  // the longest name first; a key comes after it
    --end;
    const std::string name = fmt::format("{}", fmt::join(first, end, "."));
    if (!names_one(*section, name)) continue;
    *first = name;
    o.path.erase(first + 1, end);
    break;
  }
  return o;
}

bool well_formed(const Override& o) {
  return !o.path.empty() && o.path.size() <= longest_path &&
         std::none_of(o.path.begin(), o.path.end(), [](const std::string& word) { return word.empty(); });
}

/// {value = ...}: as TOML, or as a text where that is none. The argument stays with it as its source.
toml::table parse_value(const Override& o) {
  const auto is_sound = [](const toml::table& table) { return table.size() == 1 && table.contains("value"); };
  try {
    if (o.value.find_first_of("\r\n") == std::string::npos) {
      toml::table table = toml::parse("value = " + o.value, o.argument);
      if (is_sound(table)) return table;
    }
  } catch (const toml::parse_error&) {
    // A bare word, as shells leave of a quoted one.
  }
  toml::table table = toml::parse("value = ''", o.argument);
  *table["value"].as_string() = o.value;
  return table;
}

toml::key key_of(const std::string& word, const Override& o) {
  return toml::key(word, toml::source_region{{1, 1}, {1, 1}, std::make_shared<const std::string>(o.argument)});
}

/// An entry of a list of tables by its name, or else its index; null if there is none.
toml::table* entry(toml::array& list, const std::string& word) {
  for (auto& node : list) {
    toml::table* table = node.as_table();
    if (table != nullptr && (*table)["name"].value<std::string>() == word) return table;
  }
  std::size_t index = 0;
  const char* end = word.data() + word.size();
  const auto [stopped, failed] = std::from_chars(word.data(), end, index);
  return failed == std::errc() && stopped == end && index < list.size() ? list[index].as_table() : nullptr;
}

std::vector<std::string> names_in(const toml::array& list) {
  std::vector<std::string> names;
  for (const auto& node : list) {
    const toml::table* table = node.as_table();
    if (const auto name = table != nullptr ? (*table)["name"].value<std::string>() : std::nullopt)
      names.push_back(*name);
  }
  return names;
}

/// The override of each entry of a list that bears its name: lines on one layer of a drawing share one.
std::vector<Override> of_each(const toml::table& file, const Override& o) {
  constexpr std::size_t with_key = 3;
  const toml::array* list = file[o.path.front()].as_array();
  if (list == nullptr || o.path.size() < with_key) return {o};
  std::vector<Override> all;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::table* table = (*list)[i].as_table();
    if (table == nullptr || (*table)["name"].value<std::string>() != o.path[1]) continue;
    all.push_back(o);
    all.back().path[1] = std::to_string(i);
  }
  return all.size() > 1 ? all : std::vector<Override>{o};
}

class Descent {
 public:
  Descent(toml::table& file, const Override& o, Problems& problems) : here_(&file), override_(o), problems_(problems) {}

  /// The table that holds the last word of the path; sections that are absent are made. Null and reported if there
  /// is no way.
  toml::table* to_last() {
    const auto& path = override_.path;
    for (std::size_t i = 0; here_ != nullptr && i + 1 < path.size(); ++i) {
      if (!here_->contains(path[i])) here_->insert(key_of(path[i], override_), toml::table{});
      toml::node& next = *here_->get(path[i]);
      if (toml::array* list = next.as_array(); list != nullptr && i + 2 < path.size()) {
        enter(*list, path[i], path[i + 1]);
        ++i;
      } else if (next.is_table()) {
        here_ = next.as_table();
      } else {
        refuse(fmt::format("\"{}\" has no keys", path[i]), "section.key=value, or list.name.key=value", "");
      }
    }
    return here_;
  }

 private:
  void enter(toml::array& list, const std::string& section, const std::string& word) {
    here_ = entry(list, word);
    if (here_ != nullptr) return;
    const auto names = names_in(list);
    refuse(fmt::format("no [[{}]] is \"{}\"", section, word),
           fmt::format("an index below {} or {}", list.size(), one_of(names)), did_you_mean(word, names));
  }
  void refuse(std::string found, std::string expected, std::string remedy) {
    problems_.error({override_.argument, 0}, std::move(found), std::move(expected), std::move(remedy));
    here_ = nullptr;
  }

  toml::table* here_;
  const Override& override_;
  Problems& problems_;
};

}  // namespace

std::string override_place(const std::string& argument) {
  return "--set " + argument;
}

std::string setting_key(const std::string& setting) {
  return boost::trim_copy(setting.substr(0, setting.find('=')));
}

std::string plain_key(const toml::table& file, const std::string& key) {
  const std::vector<std::string> path = split(file, key + "=").path;
  const toml::array* list = path.empty() ? nullptr : file[path.front()].as_array();
  if (list == nullptr || path.size() < 2) return key;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::table* table = (*list)[i].as_table();
    if (table == nullptr || (*table)["name"].value<std::string>() != path[1]) continue;
    return fmt::format("{}.{}{}", path.front(), i, key.substr(path.front().size() + 1 + path[1].size()));
  }
  return key;
}

void apply_overrides(toml::table& file, const std::vector<std::string>& overrides, Problems& problems) {
  for (const std::string& argument : overrides) {
    const Override o = split(file, argument);
    if (!well_formed(o)) {
      const bool has_no_value = !argument.empty() && argument.find('=') == std::string::npos;
      problems.error({o.argument, 0}, has_no_value ? "this gives no value" : "this names no key", "section.key=value",
                     "write for example --set analysis.step_s=0.001 or --set block.top.fixed=true");
      continue;
    }
    for (const Override& one : of_each(file, o)) {
      toml::table value = parse_value(one);
      if (toml::table* table = Descent(file, one, problems).to_last()) {
        // Moved, not copied: a copy of a node forgets its source.
        value.get("value")->visit(
            [&](auto& node) { table->insert_or_assign(key_of(one.path.back(), one), std::move(node)); });
      }
    }
  }
}

}  // namespace blockweir::scene
