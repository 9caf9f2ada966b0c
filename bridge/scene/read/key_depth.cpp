// SPDX-License-Identifier: GPL-3.0-or-later
// How deep the dotted keys of a TOML text go, before it is parsed.
#include "bridge/scene/read/key_depth.hpp"

#include <algorithm>
#include <string>

namespace blockweir::scene {
namespace {

/// Where the text that opens at `start` with one quote or three ends: one past its last quote, or the end of all.
std::size_t end_of_text(std::string_view toml, std::size_t start) {
  const char quote = toml[start];
  const bool many = toml.substr(start, 3) == std::string(3, quote);
  const std::string close(many ? 3 : 1, quote);
  for (std::size_t i = start + close.size(); i < toml.size(); ++i) {
    if (toml[i] == '\\' && quote == '"') {
      ++i;
    } else if (toml[i] == '\n' && !many) {
      return i;
    } else if (toml.substr(i, close.size()) == close) {
      // Up to two quotes may stand right before the three that close.
      std::size_t end = i + close.size();
      while (many && end < std::min(i + 5, toml.size()) && toml[end] == quote) ++end;
      return end;
    }
  }
  return toml.size();
}

}  // namespace

DeepKey deepest_key(std::string_view toml) {
  DeepKey deepest;
  DeepKey here;
  for (std::size_t i = 0; i < toml.size();) {
    const char c = toml[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = end_of_text(toml, i);
      here.line += static_cast<int>(std::count(toml.begin() + static_cast<std::ptrdiff_t>(i),
                                               toml.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      i = end;
      continue;
    }
    if (c == '#') {
      i = std::min(toml.find('\n', i), toml.size());
      continue;
    }
    if (c == '.' && ++here.parts > deepest.parts) deepest = here;
    if (c == '\n') ++here.line;
    if (std::string_view("\n,=[]{}").find(c) != std::string_view::npos) here.parts = 1;
    ++i;
  }
  return deepest;
}

}  // namespace blockweir::scene
