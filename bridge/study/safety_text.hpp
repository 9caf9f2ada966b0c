// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of `blockweir safety` as text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::study {

/// The table of load cases, remarks on each, and their joints. `cases`: a list as in safety.json; `of_all`: how a
/// remark on all of them begins.
[[nodiscard]] std::string safety_text(const nlohmann::json& cases, const char* of_all = "all load cases");

}  // namespace blockweir::study
