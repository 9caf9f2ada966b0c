// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/decimal_comma.hpp"

#include <fmt/format.h>

#include <regex>

namespace blockweir::scene {
namespace {

constexpr std::size_t longest = 1000;  // std::regex recurses over a text

std::string remedy_of(const std::string& text, const char* pattern) {
  std::smatch found;
  if (text.size() > longest || !std::regex_search(text, found, std::regex(pattern))) return {};
  return fmt::format("write {}.{} with a decimal point", found[1].str(), found[2].str());
}

}  // namespace

std::string remedy_of_decimal_comma(const std::string& value) {
  return remedy_of(value, R"(^([-+]?[0-9]+),([0-9]+)$)");
}

std::string remedy_of_decimal_comma_in(const std::string& line) {
  return remedy_of(line, R"(=\s*([-+]?[0-9]+),([0-9]+)\s*($|[,}#]))");
}

}  // namespace blockweir::scene
