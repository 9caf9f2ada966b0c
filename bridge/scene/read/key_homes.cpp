// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/key_homes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

namespace blockweir::scene {
namespace {

/// "### `[[block]]`" is "block.NAME"; empty for other headings.
std::string section_of(std::string_view heading) {
  const auto from = heading.find("`[");
  const auto to = heading.find("]`");
  if (from == std::string_view::npos || to == std::string_view::npos) return {};
  const bool list = heading[from + 2] == '[';
  const auto first = from + (list ? 3 : 2);
  const std::string name(heading.substr(first, to - (list ? 1 : 0) - first));
  return list ? name + ".NAME" : name;
}

}  // namespace

std::vector<std::string> homes_of_key(std::string_view key) {
  std::vector<std::string> homes;
  const std::string quoted = fmt::format("`{}`", key);
  std::istringstream page(keys_page);
  std::string section;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("#")) section = section_of(line);
    if (section.empty() || !line.starts_with("| `")) continue;
    const std::string names = line.substr(0, line.find('|', 1));
    if (names.find(quoted) != std::string::npos) homes.push_back(fmt::format("{}.{}", section, key));
  }
  return homes;
}

std::string home_advice(std::string_view key) {
  constexpr std::size_t most = 3;
  const std::vector<std::string> homes = homes_of_key(key);
  if (homes.empty() || homes.size() > most) return {};
  return fmt::format("\"{}\" belongs elsewhere: write {}", key, fmt::join(homes, " or "));
}

}  // namespace blockweir::scene
