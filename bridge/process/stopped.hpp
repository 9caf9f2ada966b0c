// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a program stopped by Ctrl-C.
#pragma once

#include <stdexcept>

namespace blockweir::process {

/// Ctrl-C was pressed before there was an answer; the program then ends with `stopped_status`.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped on request") {}
};

inline constexpr int stopped_status = 130;

}  // namespace blockweir::process
