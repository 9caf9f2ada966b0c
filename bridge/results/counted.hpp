// SPDX-License-Identifier: GPL-3.0-or-later
// Counts in messages.
#pragma once

#include <fmt/format.h>

#include <string>

namespace blockweir::results {

/// "1 block", "3 blocks"; `many` where the plural is not the word with an s.
inline std::string counted(std::size_t count, const std::string& one, const std::string& many = "") {
  return fmt::format("{} {}", count, count == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace blockweir::results
