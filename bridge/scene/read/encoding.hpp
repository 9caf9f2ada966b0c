// SPDX-License-Identifier: GPL-3.0-or-later
// Is a file text in UTF-8, and does it hold text alone?
#pragma once

#include <toml++/toml.h>
#include <optional>
#include <string>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// Where it is not, and what it is instead.
struct ForeignText {
  int line = 1;
  std::string found;
};

/// None where the text is UTF-8, with or without a byte order mark.
std::optional<ForeignText> foreign_text(const std::string& text);

/// Reports each key and text with a control character: texts reach terminals, tables and pages. Those that may have
/// several lines, as a note, keep their line ends and tabs.
void refuse_control_characters(const toml::table& file, Problems& problems);

}  // namespace blockweir::scene
