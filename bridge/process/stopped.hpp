// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody has pressed Ctrl-C.
#pragma once

#include <stdexcept>

namespace blockweir::process {

/// Ctrl-C was pressed before there was an answer; programs end with `stopped_status` then.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped on request") {}
};

inline constexpr int stopped_status = 130;

}  // namespace blockweir::process
