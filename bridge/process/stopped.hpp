// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a program stopped by Ctrl-C.
#pragma once

#include <stdexcept>
#include <string>

namespace blockweir::process {

/// Ctrl-C was pressed before there was an answer; the program then ends with `stopped_status`.
struct Stopped : std::runtime_error {
  /// `known`: what the work had found by then; may be empty.
  explicit Stopped(const std::string& known = "")
      : std::runtime_error("stopped on request" + (known.empty() ? "" : "; known by then: " + known)) {}
};

inline constexpr int stopped_status = 130;

}  // namespace blockweir::process
