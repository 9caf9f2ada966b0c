// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/key_label.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

namespace blockweir::study {
namespace {

std::string with_spaces(std::string words) {
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

/// "kg_per_m3" is "kg/m³".
std::string spelled(const std::string& unit) {
  static const std::map<std::string, std::string> signs{{"pa", "Pa"}, {"n", "N"},   {"hz", "Hz"}, {"m2", "m²"},
                                                        {"m3", "m³"}, {"s2", "s²"}, {"per", "/"}};
  std::istringstream parts(with_spaces(unit));
  std::string text;
  for (std::string part; parts >> part;) {
    const auto sign = signs.find(part);
    const bool beside = !text.empty() && part != "per" && text.back() != '/';
    text += (beside ? " " : "") + (sign == signs.end() ? part : sign->second);
  }
  return text;
}

}  // namespace

std::string key_label(const std::string& key) {
  const auto dot = key.rfind('.');
  std::string last = dot == std::string::npos ? key : key.substr(dot + 1);
  std::string owner = dot == std::string::npos ? "" : key.substr(0, dot);
  const auto name = owner.find('.');  // which keeps its underscores
  owner = with_spaces(owner.substr(0, name)) + (name == std::string::npos ? "" : " " + owner.substr(name + 1));
  static const std::regex with_unit("(.+?)_((?:kg|n|pa|m|s|deg|hz)[23]?(?:_(?:per_)?(?:kg|n|pa|m|s|deg|hz)[23]?)*)");
  std::smatch parts;
  if (std::regex_match(last, parts, with_unit)) last = parts[1].str() + " (" + spelled(parts[2]) + ")";
  const auto unit = last.find(" (");
  last = with_spaces(last.substr(0, unit)) + (unit == std::string::npos ? "" : last.substr(unit));
  return owner.empty() ? last : owner + ": " + last;
}

}  // namespace blockweir::study
