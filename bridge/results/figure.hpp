// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of a summary as people read it.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::results {

/// A number to nine digits, a word as it is, "none" for what a run has not.
inline std::string figure(const nlohmann::json& value) {
  if (value.is_number()) return fmt::format("{:.9g}", value.get<double>());
  return value.is_string() ? value.get<std::string>() : "none";
}

}  // namespace blockweir::results
