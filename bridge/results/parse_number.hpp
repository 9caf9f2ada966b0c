// SPDX-License-Identifier: GPL-3.0-or-later
// Parses numbers in cells and fields of typed or exported files.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace blockweir::results {

/// The number, if the whole text is one (a plus sign is allowed); none if it is not a number or not finite.
template <class Number>
std::optional<Number> parse_number(const std::string& text) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* const end = text.data() + text.size();
  Number value{};
  const auto [stopped, failed] = std::from_chars(begin, end, value);
  if (failed != std::errc() || stopped != end || !std::isfinite(static_cast<double>(value))) return std::nullopt;
  return value;
}

}  // namespace blockweir::results
