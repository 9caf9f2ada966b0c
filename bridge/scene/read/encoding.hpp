// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that a file is UTF-8 text without control characters.
#pragma once

#include <toml++/toml.h>
#include <optional>
#include <string>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// Place of the first foreign byte, and the probable encoding.
struct ForeignText {
  int line = 1;
  std::string found;
};

/// None if the text is UTF-8, with or without a byte order mark.
std::optional<ForeignText> foreign_text(const std::string& text);

/// Reports each key and text with a control character, since texts are printed on terminals, tables and pages. Texts
/// that may have several lines, such as a note, keep line ends and tabs.
void refuse_control_characters(const toml::table& file, Problems& problems);

}  // namespace blockweir::scene
