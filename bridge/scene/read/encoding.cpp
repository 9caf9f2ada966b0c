// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/read/encoding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

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

constexpr std::array lines_allowed = {"note", "formula", "source", "command"};

/// The number of the first control character: below U+0020, and from U+007F to U+009F (in UTF-8 0xc2 and a byte).
std::optional<unsigned> control_character(std::string_view text, bool lines) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto code = static_cast<unsigned char>(text[i]);
    if (lines && (code == '\n' || code == '\r' || code == '\t')) continue;
    if (code < 0x20 || code == 0x7f) return code;
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    if (code == 0xc2 && next >= 0x80 && next < 0xa0) return next;
  }
  return std::nullopt;
}

/// With a question mark in place of each byte that a terminal might obey.
std::string harmless(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) - 0x20U >= 0x5fU; }, '?');
  return text;
}

void look_into(const toml::node& node, const std::string& key, Problems& problems) {
  const auto refuse = [&](const toml::source_region& source, const std::string& where, unsigned code) {
    problems.error(problems.at(source), fmt::format("the control character U+{:04X} in {}", code, where),
                   "a text of letters, digits and signs in one line",
                   "take it out; a text in \"...\" has \\\\ for a backslash");
  };
  if (const auto* text = node.as_string()) {
    const bool lines = std::find(lines_allowed.begin(), lines_allowed.end(), key) != lines_allowed.end();
    if (const auto code = control_character(text->get(), lines)) refuse(node.source(), "the text of " + key, *code);
  } else if (const auto* list = node.as_array()) {
    for (const toml::node& entry : *list) look_into(entry, key, problems);
  } else if (const auto* table = node.as_table()) {
    for (const auto& [name, value] : *table) {
      const std::string word(name.str());
      if (const auto code = control_character(word, false)) {
        refuse(name.source(), "the key \"" + harmless(word) + '"', *code);
      } else {
        look_into(value, word, problems);
      }
    }
  }
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

void refuse_control_characters(const toml::table& file, Problems& problems) {
  look_into(file, "", problems);
}

}  // namespace blockweir::scene
