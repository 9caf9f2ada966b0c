// SPDX-License-Identifier: GPL-3.0-or-later
// A value of a summary as readable text.
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::results {

/// The number that a user would type, by twelve digits: 13.4 for a sum of 13.399999999999999.
inline double without_rounding_error(double value) {
  return std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr);
}

/// A number with nine digits, a word as it is, "none" for a missing value.
inline std::string figure(const nlohmann::json& value) {
  if (value.is_number()) return fmt::format("{:.9g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : "none";
}

}  // namespace blockweir::results
