// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/encoding.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace blockweir::scene {
namespace {

/// Bytes of the character that begins at `at`; 0 where none does.
std::size_t length_of(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t length = first < 0x80                     ? 1
                             : first >= 0xc2 && first <= 0xdf ? 2
                             : first >= 0xe0 && first <= 0xef ? 3
                             : first >= 0xf0 && first <= 0xf4 ? 4
                                                              : 0;
  if (at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  }
  return length;
}

}  // namespace

std::optional<ForeignText> foreign_text(const std::string& text) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return ForeignText{1, "text in UTF-16"};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = length_of(text, at);
    if (length == 0 || text[at] == '\0') {
      const auto begin = text.begin();
      const auto line = 1 + std::count(begin, begin + static_cast<std::ptrdiff_t>(at), '\n');
      return ForeignText{static_cast<int>(line),
                         fmt::format("a byte 0x{:02x} that is no character", static_cast<unsigned char>(text[at]))};
    }
    at += length;
  }
  return std::nullopt;
}

}  // namespace blockweir::scene
