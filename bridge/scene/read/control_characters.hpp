// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of a scene reach terminals, tables and pages: none may hold a character that controls them.
#pragma once

#include <toml++/toml.h>

#include "bridge/scene/read/problems.hpp"

namespace blockweir::scene {

/// Reports each key and text with a control character. Texts that may have several lines, as a note, keep their line
/// ends and tabs.
void refuse_control_characters(const toml::table& file, Problems& problems);

}  // namespace blockweir::scene
