// SPDX-License-Identifier: GPL-3.0-or-later
// What one method of blockweir reliability found, as text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::study {

/// "-" for what is no number.
std::string digits_of(const nlohmann::json& value, const char* format = "{:.4g}");

/// `answer`: content of reliability.json. Empty if the method was not asked; NONE and the reason without an answer.
std::string method_text(const nlohmann::json& answer, const char* method);

}  // namespace blockweir::study
