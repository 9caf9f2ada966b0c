// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of tables for a terminal of 80 columns.
#pragma once

#include <string>

namespace blockweir::study {

/// `left` at the start of the line and `right` ending at column `width`, on two lines if necessary.
inline std::string table_line(const std::string& left, const std::string& right, std::size_t width = 80) {
  if (right.empty()) return left + "\n";
  const std::size_t used = left.size() + right.size();
  if (used < width) return left + std::string(width - used, ' ') + right + "\n";
  const std::size_t before = right.size() < width ? width - right.size() : 0;
  return left + "\n" + std::string(before, ' ') + right + "\n";
}

}  // namespace blockweir::study
