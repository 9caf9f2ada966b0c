// SPDX-License-Identifier: GPL-3.0-or-later
// A short hash of a text, to check that two processes have the same scene. Not for security.
#pragma once

#include <string>
#include <string_view>

namespace blockweir::scene {

/// 16 hexadecimal digits: FNV-1a, 64 bit (Fowler, Noll, Vo).
std::string digest(std::string_view text);

}  // namespace blockweir::scene
