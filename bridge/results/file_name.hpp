// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a name of the scene into a file or folder name.
#pragma once

#include <string>

namespace blockweir::results {

/// Letters and digits stay, in any script (UTF-8); everything else becomes a hyphen. Two names may give the same file
/// name: the scene reader refuses that (UniqueFileNames).
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
