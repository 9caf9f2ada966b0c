// SPDX-License-Identifier: GPL-3.0-or-later
// A name that a scene gives, as that of a file or folder.
#pragma once

#include <string>

namespace blockweir::results {

/// Letters and digits stay, in any script (UTF-8); all else becomes a hyphen. Two names may become one: the reader of
/// scenes refuses that (UniqueFileNames).
inline std::string file_name(std::string name) {
  const auto stays = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0;
  };
  for (char& c : name) {
    if (!stays(c)) c = '-';
  }
  return name;
}

}  // namespace blockweir::results
