// SPDX-License-Identifier: GPL-3.0-or-later
// What a skip has saved, by what the same run took for what it did not skip.
#pragma once

#include <fmt/format.h>

#include <string>

namespace blockweir::results {

/// Ends a line on a skip; nothing where no time is known.
inline std::string saved(double seconds) {
  return seconds > 0 ? fmt::format(", saved about {:.2g} s", seconds) : "";
}

/// `skipped` times of what took `seconds` for the `done` others.
inline std::string saved(double seconds, long done, long skipped) {
  return done > 0 ? saved(seconds / static_cast<double>(done) * static_cast<double>(skipped)) : "";
}

}  // namespace blockweir::results
