// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bridge/scene/nearest.hpp"

namespace blockweir::scene {
namespace {

std::string shown(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) {
    if constexpr (toml::is_table<decltype(value)> || toml::is_array<decltype(value)>) {
      text << (toml::is_table<decltype(value)> ? "a table" : "a list");
    } else {
      text << value;
    }
  });
  return text.str();
}

}  // namespace

void Problems::error(int line, std::string found, std::string expected, std::string remedy) {
  errors_.push_back(
      {Diagnostic::Severity::error, file_, line, std::move(found), std::move(expected), std::move(remedy)});
}

void Problems::note(int line, std::string found, std::string remedy) {
  notes_.push_back({Diagnostic::Severity::note, file_, line, std::move(found), "", std::move(remedy)});
}

Range any_number() {
  return {[](double) { return true; }, "a number"};
}
Range positive() {
  return {[](double x) { return x > 0; }, "a number above 0"};
}
Range not_negative() {
  return {[](double x) { return x >= 0; }, "a number of at least 0"};
}
Range between(double low, double high, const char* words) {
  return {[low, high](double x) { return x >= low && x < high; }, words};
}

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const std::string near = nearest(word, names);
  return near.empty() ? "" : fmt::format("did you mean \"{}\"?", near);
}

TableReader::TableReader(Problems& problems, const toml::table* table, std::string name, int line)
    : problems_(problems), table_(table), name_(std::move(name)), line_(table != nullptr ? line_of(*table) : line) {}

TableReader::~TableReader() {
  if (table_ == nullptr) return;
  for (const auto& [key, node] : *table_) {
    const std::string word(key.str());
    if (std::find(asked_.begin(), asked_.end(), word) != asked_.end()) continue;
    problems_.error(static_cast<int>(key.source().begin.line), fmt::format("unknown key \"{}\" in {}", word, name_),
                    fmt::format("one of {}", fmt::join(asked_, ", ")), did_you_mean(word, asked_));
  }
}

int TableReader::line(const char* key) const {
  return has(key) ? line_of(*table_->get(key)) : line_;
}

const toml::node* TableReader::ask(const char* key, bool required, const char* expected) {
  asked_.emplace_back(key);
  const toml::node* node = table_ != nullptr ? table_->get(key) : nullptr;
  if (node == nullptr && required) {
    problems_.error(line_, fmt::format("{} has no \"{}\"", name_, key), expected, fmt::format("add {} = ...", key));
  }
  return node;
}

void TableReader::wrong_type(const char* key, const toml::node& node, const char* expected) {
  problems_.error(line_of(node), fmt::format("{} in {} is {}", key, name_, shown(node)), expected);
}

void TableReader::not_one_of(const char* key, const std::string& word, const std::vector<std::string>& names) {
  problems_.error(line(key), fmt::format("{} in {} is \"{}\"", key, name_, word),
                  fmt::format("one of {}", fmt::join(names, ", ")), did_you_mean(word, names));
}

void TableReader::number(const char* key, double& into, const Range& range, bool required) {
  const toml::node* node = ask(key, required, range.words);
  if (node == nullptr) return;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value) || !range.holds(*value)) return wrong_type(key, *node, range.words);
  into = *value;
}

void TableReader::number(const char* key, std::optional<double>& into, const Range& range) {
  double value = 0;
  const std::size_t before = problems_.errors().size();
  number(key, value, range);
  if (has(key) && problems_.errors().size() == before) into = value;
}

void TableReader::integer(const char* key, int& into, int least) {
  const std::string words = fmt::format("a whole number of at least {}", least);
  const toml::node* node = ask(key, false, words.c_str());
  if (node == nullptr) return;
  const auto value = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
  if (!value || *value < least || *value > 1'000'000'000) return wrong_type(key, *node, words.c_str());
  into = static_cast<int>(*value);
}

void TableReader::flag(const char* key, bool& into) {
  const toml::node* node = ask(key, false, "true or false");
  if (node == nullptr) return;
  if (!node->is_boolean()) return wrong_type(key, *node, "true or false");
  into = *node->value<bool>();
}

void TableReader::text(const char* key, std::string& into, bool required) {
  const toml::node* node = ask(key, required, "a text in quotes");
  if (node == nullptr) return;
  if (!node->is_string()) return wrong_type(key, *node, "a text in quotes");
  into = *node->value<std::string>();
}

void TableReader::texts(const char* key, std::vector<std::string>& into, std::size_t count) {
  const std::string words = fmt::format("a list of {} names", count);
  const toml::node* node = ask(key, true, words.c_str());
  if (node == nullptr) return;
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() != count || !list->is_homogeneous<std::string>()) {
    return wrong_type(key, *node, words.c_str());
  }
  for (const auto& entry : *list) into.push_back(*entry.value<std::string>());
}

bool TableReader::read_point(const toml::node& node, Point& into) {
  const toml::array* pair = node.as_array();
  if (pair == nullptr || pair->size() != 2 || !(*pair)[0].is_number() || !(*pair)[1].is_number()) return false;
  into = Point(*(*pair)[0].value<double>(), *(*pair)[1].value<double>());
  return into.allFinite() && into.cwiseAbs().maxCoeff() < 1e9;
}

void TableReader::point(const char* key, Point& into, bool required) {
  constexpr const char* words = "a pair of numbers [x, y]";
  const toml::node* node = ask(key, required, words);
  if (node != nullptr && !read_point(*node, into)) wrong_type(key, *node, words);
}

void TableReader::points(const char* key, std::vector<Point>& into) {
  constexpr const char* words = "a list of at least three pairs of numbers [[x, y], ...]";
  const toml::node* node = ask(key, true, words);
  if (node == nullptr) return;
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() < 3) return wrong_type(key, *node, words);
  for (const auto& entry : *list) {
    Point p;
    if (!read_point(entry, p)) return wrong_type(key, entry, "a pair of numbers [x, y] in metres");
    into.push_back(p);
  }
}

bool TableReader::read_rows(const char* key, const toml::node& node, TimeTable& into) {
  constexpr const char* words = "rows [[time_s, value], ...] with increasing times";
  const toml::array* rows = node.as_array();
  if (rows == nullptr || rows->empty()) return wrong_type(key, node, words), false;
  for (const auto& row : *rows) {
    Point p;
    if (!read_point(row, p) || (!into.time_s.empty() && p.x() <= into.time_s.back())) {
      return wrong_type(key, row, words), false;
    }
    into.time_s.push_back(p.x());
    into.value.push_back(p.y());
  }
  return true;
}

void TableReader::time_table(const char* key, std::optional<TimeTable>& into, double duration_s) {
  constexpr const char* words =
      "a number, { table = [[time_s, value], ...] }, { steps = [[time_s, value], ...] } or "
      "{ from = value, rate_per_s = value }";
  const toml::node* node = ask(key, false, words);
  if (node == nullptr) return;
  if (node->is_number() && std::isfinite(*node->value<double>())) {
    into = TimeTable::constant(*node->value<double>());
    return;
  }
  const toml::table* described = node->as_table();
  if (described == nullptr) return wrong_type(key, *node, words);
  TableReader inner(problems_, described, fmt::format("{} of {}", key, name_), line_of(*node));
  const toml::node* table = inner.ask("table", false, words);
  const toml::node* steps = inner.ask("steps", false, words);
  double from = 0;
  double rate = 0;
  inner.number("from", from);
  inner.number("rate_per_s", rate);
  TimeTable read;
  if (table != nullptr || steps != nullptr) {
    read.stepwise = steps != nullptr;
    if (!inner.read_rows(key, steps != nullptr ? *steps : *table, read)) return;
  } else if (described->contains("from") && described->contains("rate_per_s")) {
    read = {.time_s = {0, duration_s}, .value = {from, from + rate * duration_s}};
  } else {
    return wrong_type(key, *node, words);
  }
  into = read;
}

int TableReader::reference(const char* key, const char* what, const std::vector<std::string>& names, bool required) {
  std::string word;
  text(key, word, required);
  if (word.empty()) return -1;
  const auto found = std::find(names.begin(), names.end(), word);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  problems_.error(line(key), fmt::format("{} in {} names no {}: \"{}\"", key, name_, what, word),
                  fmt::format("one of {}", fmt::join(names, ", ")), did_you_mean(word, names));
  return -1;
}

}  // namespace blockweir::scene
