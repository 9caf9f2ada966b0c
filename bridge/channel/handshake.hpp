// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that both sides belong to the same run.
#pragma once

#include <string>

#include "bridge/wire/message.hpp"

namespace blockweir::channel {

/// All differences that matter, with both sides' values; empty if there are none. Role and build may differ.
std::string compare(const wire::Hello& ours, const wire::Hello& theirs);

/// A name sent by a stranger, made short and printable on one line.
std::string printable(std::string name);

}  // namespace blockweir::channel
