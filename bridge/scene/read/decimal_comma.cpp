// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/decimal_comma.hpp"

#include <fmt/format.h>

#include <regex>

namespace blockweir::scene {
namespace {

constexpr std::size_t longest = 1000;  // std::regex recurses over a text

std::string remedy_of(const std::string& text, const std::regex& pattern) {
  std::smatch found;
  if (text.size() > longest || !std::regex_search(text, found, pattern)) return {};
  return fmt::format("write {}.{} with a decimal point", found[1].str(), found[2].str());
}

}  // namespace

std::string remedy_of_decimal_comma(const std::string& value) {
  static const std::regex whole(R"(^([-+]?[0-9]+),([0-9]+)$)");
  return remedy_of(value, whole);
}

std::string remedy_of_decimal_comma_in(const std::string& line) {
  static const std::regex after_equals(R"(=\s*([-+]?[0-9]+),([0-9]+)\s*($|[,}#]))");
  return remedy_of(line, after_equals);
}

}  // namespace blockweir::scene
