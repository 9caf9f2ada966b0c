// SPDX-License-Identifier: GPL-3.0-or-later
// Counts with a noun, for messages.
#pragma once

#include <fmt/format.h>

#include <string>

namespace blockweir::results {

/// "1 block", "3 blocks"; `many`: the plural, if it is not formed with s.
inline std::string counted(std::size_t count, const std::string& one, const std::string& many = "") {
  return fmt::format("{} {}", count, count == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace blockweir::results
