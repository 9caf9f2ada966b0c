// SPDX-License-Identifier: GPL-3.0-or-later
// A name that a scene gives, as that of a file or folder.
#pragma once

#include <cctype>
#include <string>

namespace blockweir::results {

/// Letters and digits stay, all else becomes a hyphen.
inline std::string file_name(std::string name) {
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  }
  return name;
}

}  // namespace blockweir::results
