// SPDX-License-Identifier: GPL-3.0-or-later
// A value of a summary as readable text.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::results {

/// A number with nine digits, a word as it is, "none" for a missing value.
inline std::string figure(const nlohmann::json& value) {
  if (value.is_number()) return fmt::format("{:.9g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : "none";
}

}  // namespace blockweir::results
