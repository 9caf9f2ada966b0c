// SPDX-License-Identifier: GPL-3.0-or-later
// Is a file text in UTF-8?
#pragma once

#include <optional>
#include <string>

namespace blockweir::scene {

/// Where it is not, and what it is instead.
struct ForeignText {
  int line = 1;
  std::string found;
};

/// None where the text is UTF-8, with or without a byte order mark.
std::optional<ForeignText> foreign_text(const std::string& text);

}  // namespace blockweir::scene
