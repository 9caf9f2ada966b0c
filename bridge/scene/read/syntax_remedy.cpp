// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/syntax_remedy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <regex>

#include "bridge/scene/read/decimal_comma.hpp"

namespace blockweir::scene {
namespace {

constexpr std::size_t longest = 1000;  // std::regex recurses over a text

bool has_curly_quotes(const std::string& line) {
  const std::array<const char*, 6> quotes{"\u201c", "\u201d", "\u201e", "\u2018", "\u2019", "\u00ab"};
  return std::any_of(quotes.begin(), quotes.end(),
                     [&](const char* quote) { return line.find(quote) != std::string::npos; });
}

/// Of texts that end on their line.
bool leaves_a_text_open(const std::string& line) {
  if (line.find("\"\"\"") != std::string::npos) return false;
  bool open = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\')
      ++i;
    else if (line[i] == '"')
      open = !open;
    else if (line[i] == '#' && !open)
      break;
  }
  return open;
}

/// Of a value that stands alone behind its key.
std::string remedy_of_value(const std::string& line) {
  static const std::regex yes(R"(=\s*(yes|Yes|YES|on|On|ON|True|TRUE)\s*($|#))");
  static const std::regex no(R"(=\s*(no|No|NO|off|Off|OFF|False|FALSE)\s*($|#))");
  static const std::regex number(R"(=\s*([-+]?[0-9]+\.?[0-9]*(?:[eE][-+]?[0-9]+)?)\s*([^\s#]*)\s*($|#))");
  if (std::regex_search(line, yes)) return "write true";
  if (std::regex_search(line, no)) return "write false";
  std::smatch found;
  if (!std::regex_search(line, found, number)) return {};
  if (std::isinf(std::strtod(found[1].str().c_str(), nullptr))) return "write a smaller number";
  const std::string unit = found[2].str();
  if (unit.empty() || std::isdigit(static_cast<unsigned char>(unit.front())) != 0) return {};
  if (std::string(".,-+_").find(unit.front()) != std::string::npos) return {};
  return fmt::format("write {} alone: the unit is in the key's name", found[1].str());
}

}  // namespace

std::string remedy_of_syntax(const std::string& line) {
  const bool ends_of_an_old_mac = line.find('\r') < line.size() - 1;
  if (!line.empty() && ends_of_an_old_mac) return "save the file with line ends of Unix (LF) or Windows (CRLF)";
  if (line.size() <= longest) {
    if (std::string decimal = remedy_of_decimal_comma_in(line); !decimal.empty()) return decimal;
    if (has_curly_quotes(line)) return "write straight quotes (\"), not those of a word processor";
    if (std::string value = remedy_of_value(line); !value.empty()) return value;
  }
  if (leaves_a_text_open(line)) return "a quote is missing: a text begins and ends with one, on one line";
  return "correct the line; texts stand in quotes, lists in [ ], sections on lines of their own";
}

}  // namespace blockweir::scene
