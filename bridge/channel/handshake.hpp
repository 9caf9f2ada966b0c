// SPDX-License-Identifier: GPL-3.0-or-later
// Do both sides mean the same run?
#pragma once

#include <string>

#include "bridge/wire/message.hpp"

namespace blockweir::channel {

/// All that differs, with both sides' values; empty when nothing that matters does (role and build may differ).
std::string compare(const wire::Hello& ours, const wire::Hello& theirs);

/// What a stranger calls itself, on one short line.
std::string printable(std::string name);

}  // namespace blockweir::channel
