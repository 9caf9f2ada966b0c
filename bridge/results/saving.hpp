// SPDX-License-Identifier: GPL-3.0-or-later
// The time saved by skipped work, estimated from the time of the same work in this run.
#pragma once

#include <fmt/format.h>

#include <string>

namespace blockweir::results {

/// The end of a line on skipped work; empty if no time is known.
inline std::string saved(double seconds) {
  return seconds > 0 ? fmt::format(", saved about {:.2g} s", seconds) : "";
}

/// For `skipped` repetitions of work of which `done` repetitions took `seconds`.
inline std::string saved(double seconds, long done, long skipped) {
  return done > 0 ? saved(seconds / static_cast<double>(done) * static_cast<double>(skipped)) : "";
}

}  // namespace blockweir::results
