// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of `blockweir safety` as a terminal shows them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::study {

/// The table of load cases, what is to be said of each, and their joints. `cases`: a list as safety.json has it.
[[nodiscard]] std::string safety_text(const nlohmann::json& cases);

}  // namespace blockweir::study
