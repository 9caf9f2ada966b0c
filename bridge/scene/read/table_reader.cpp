// SPDX-License-Identifier: GPL-3.0-or-later
// Reads one TOML table key by key: types, ranges, defaults, and which keys nobody asked for.
#include "bridge/scene/read/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "bridge/scene/read/decimal_comma.hpp"
#include "bridge/scene/read/key_advice.hpp"
#include "bridge/scene/read/nearest.hpp"

namespace blockweir::scene {
namespace {

std::string shown(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (const toml::array* list = node.as_array()) {
    return list->empty() ? "an empty list" : fmt::format("a list of {}", list->size());
  }
  if (const auto number = node.as_floating_point())
    return fmt::format("{}", number->get());  // 0.6, not 17 digits of it
  std::ostringstream stream;
  node.visit([&](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) stream << value;
  });
  const std::string text = stream.str();
  return text.size() > 40 ? fmt::format("{}...", text.substr(0, 37)) : text;
}

/// A number, true or false within quotes.
bool is_quoted_value(const toml::node& node) {
  const auto text = node.value_exact<std::string>();
  if (!text || text->empty()) return false;
  char* end = nullptr;
  std::strtod(text->c_str(), &end);
  return *end == '\0' || *text == "true" || *text == "false";
}

}  // namespace

std::optional<double> finite_number(const toml::node& node) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  return value && std::isfinite(*value) ? value : std::nullopt;
}

Range any_number() {
  return {[](double) { return true; }, "a finite number"};
}
Range positive() {
  return {[](double x) { return x > 0; }, "a number above 0"};
}
Range not_negative() {
  return {[](double x) { return x >= 0; }, "a number of at least 0"};
}

Range drawn_length() {
  return {[](double x) { return x > 0 && x < 1e6; }, "a number above 0, below 1e6"};
}

TableKeys::TableKeys(Problems& problems, const toml::table* table, std::string name)
    : problems_(problems), table_(table), name_(std::move(name)) {}

TableKeys::~TableKeys() {
  if (table_ == nullptr) return;
  for (const auto& [key, node] : *table_) {
    const std::string word(key.str());
    if (problems_.full()) return;
    if (std::find(asked_.begin(), asked_.end(), word) != asked_.end()) continue;
    const KeyAdvice advice = key_advice(word, asked_);
    problems_.error(problems_.at(key.source()), fmt::format("unknown key \"{}\" in {}", word, name_), advice.expected,
                    advice.remedy);
  }
}

Place TableKeys::place() const {
  return present() ? problems_.at(table_->source()) : problems_.at(0);
}

Place TableKeys::place(const char* key) const {
  return has(key) ? problems_.at(table_->get(key)->source()) : place();
}

Place TableKeys::place(const char* key, std::size_t entry) const {
  const toml::array* list = has(key) ? table_->get(key)->as_array() : nullptr;
  return list != nullptr && entry < list->size() ? problems_.at((*list)[entry].source()) : place(key);
}

const toml::node* TableKeys::ask(const char* key, bool required, const std::string& expected) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
  const toml::node* node = table_ != nullptr ? table_->get(key) : nullptr;
  if (node == nullptr && required) {
    problems_.error(place(), fmt::format("{} has no \"{}\"", name_, key), expected, fmt::format("add {} = ...", key));
  }
  return node;
}

bool TableKeys::wrong(const char* key, const toml::node& node, const std::string& expected, const std::string& remedy) {
  const std::string decimal = remedy_of_decimal_comma(node.value_or(std::string()));
  const bool quoted = is_quoted_value(node) && expected.find("text") == std::string::npos;
  problems_.error(problems_.at(node.source()),
                  fmt::format("{} in {} is {}{}", key, name_, quoted ? "the text " : "", shown(node)), expected,
                  !decimal.empty() ? decimal
                  : quoted         ? "take off the quotes"
                  : remedy.empty() ? fmt::format("correct {}", key)
                                   : remedy);
  return false;
}

bool TableKeys::not_one_of(const char* key, const std::string& word, const std::vector<std::string>& known) {
  problems_.error(place(key), fmt::format("{} in {} is \"{}\"", key, name_, word), one_of(known),
                  did_you_mean(word, known));
  return false;
}

bool TableReader::number(const char* key, double& into, const Range& range, bool required) {
  const toml::node* node = ask(key, required, range.words);
  if (node == nullptr) return false;
  const auto value = finite_number(*node);
  if (!value && node->is_number()) return wrong(key, *node, "a finite number");  // inf may be within the range
  if (!value || !range.holds(*value)) return wrong(key, *node, range.words);
  into = *value;
  return true;
}

bool TableReader::number(const char* key, std::optional<double>& into, const Range& range) {
  double value = 0;
  if (!number(key, value, range)) return false;
  into = value;
  return true;
}

bool TableReader::numbers(const char* key, std::vector<double>& into, const Range& range, std::size_t least) {
  const std::string words = fmt::format("a list of at least {}, each {}", least, range.words);
  const toml::node* node = ask(key, true, words);
  if (node == nullptr) return false;
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() < least) return wrong(key, *node, words);
  for (const auto& entry : *list) {
    const auto value = finite_number(entry);
    if (!value || !range.holds(*value)) return wrong(key, entry, range.words);
    into.push_back(*value);
  }
  return true;
}

bool TableReader::settings(const char* key, std::vector<std::string>& into) {
  constexpr const char* words = "a list of at least 1, each a finite number, true, false or a text";
  const toml::node* node = ask(key, true, words);
  if (node == nullptr) return false;
  const toml::array* list = node->as_array();
  if (list == nullptr || list->empty()) return wrong(key, *node, words);
  for (const auto& entry : *list) {
    if (const auto number = finite_number(entry)) {
      const std::string brief = fmt::format("{:g}", *number);  // 1e+13, not 10000000000000
      into.push_back(std::strtod(brief.c_str(), nullptr) == *number ? brief : fmt::format("{}", *number));
    } else if (entry.is_string()) {
      into.push_back(*entry.value<std::string>());
    } else if (entry.is_boolean()) {
      into.emplace_back(*entry.value<bool>() ? "true" : "false");
    } else {
      return wrong(key, entry, words);
    }
  }
  return true;
}

bool TableReader::integer(const char* key, int& into, int least, int most) {
  const std::string words = fmt::format("a whole number from {} to {}", least, most);
  const toml::node* node = ask(key, false, words);
  if (node == nullptr) return false;
  const auto value = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
  if (!value || *value < least || *value > most) return wrong(key, *node, words);
  into = static_cast<int>(*value);
  return true;
}

bool TableReader::flag(const char* key, bool& into) {
  const toml::node* node = ask(key, false, "true or false");
  if (node == nullptr) return false;
  if (!node->is_boolean()) return wrong(key, *node, "true or false");
  into = *node->value<bool>();
  return true;
}

bool TableReader::text(const char* key, std::string& into, bool required) {
  const std::string words = required ? "a text that is not empty, in quotes" : "a text in quotes";
  const toml::node* node = ask(key, required, words);
  if (node == nullptr) return false;
  const auto value = node->is_string() ? node->value<std::string>() : std::nullopt;
  if (!value || (required && value->empty())) return wrong(key, *node, words);
  constexpr std::size_t longest_name = 200;
  if (std::string_view(key) == "name" && value->size() > longest_name) {
    return wrong(key, *node, fmt::format("a name of at most {} letters", longest_name), "shorten it");
  }
  into = *value;
  return true;
}

bool TableReader::word(const char* key, std::string& into, const std::vector<std::string>& known, bool required) {
  if (!text(key, into, required)) return false;
  return std::find(known.begin(), known.end(), into) != known.end() || not_one_of(key, into, known);
}

bool TableReader::texts(const char* key, std::vector<std::string>& into, std::optional<std::size_t> count,
                        bool may_be_empty) {
  const std::string words = count ? fmt::format("a list of {} names", *count) : "a list of texts";
  const toml::node* node = ask(key, true, words);
  if (node == nullptr) return false;
  const toml::array* list = node->as_array();
  if (list != nullptr && list->empty() && !count && !may_be_empty) {
    const bool sets = std::string_view(key) == "set";
    return wrong(key, *node, sets ? "at least one text \"key=value\"" : "at least one text",
                 fmt::format("state what it {}, such as {} = [\"{}\"]", sets ? "changes" : "is to name", key,
                             sets ? "joint.friction_angle_deg=25" : "..."));
  }
  const bool all_texts = list != nullptr && (list->empty() || list->is_homogeneous<std::string>());
  if (!all_texts || list->size() != count.value_or(list->size())) return wrong(key, *node, words);
  for (const auto& entry : *list) into.push_back(*entry.value<std::string>());
  return true;
}

bool TableReader::texts_if_any(const char* key, std::vector<std::string>& into) {
  know(key);
  if (!has(key)) return false;
  texts(key, into);
  return true;
}

const toml::table* TableReader::table(const char* key) {
  const toml::node* node = ask(key, false, "");
  if (node == nullptr || node->is_table()) return node == nullptr ? nullptr : node->as_table();
  wrong(key, *node, "a table { key = value, ... }");
  return nullptr;
}

std::vector<const toml::table*> TableReader::tables(const char* key, bool required) {
  constexpr const char* words = "a list of tables [{ key = value, ... }, ...]";
  const toml::node* node = ask(key, required, words);
  if (node == nullptr) return {};
  const toml::array* list = node->as_array();
  if (list == nullptr || !list->is_array_of_tables()) {
    wrong(key, *node, words);
    return {};
  }
  std::vector<const toml::table*> all;
  for (const auto& entry : *list) all.push_back(entry.as_table());
  return all;
}

int TableReader::reference(const char* key, const Names& names, bool required) {
  std::string word;
  if (!text(key, word, required)) return -1;
  const int index = names.find(word);
  if (index >= 0 || !names.complete()) return index;
  problems_.error(place(key), fmt::format("{} in {} names no {}: \"{}\"", key, name_, names.kind(), word),
                  one_of(names.list()),
                  word.empty() ? fmt::format("name one, or leave {} out", key) : did_you_mean(word, names.list()));
  return -1;
}

}  // namespace blockweir::scene
