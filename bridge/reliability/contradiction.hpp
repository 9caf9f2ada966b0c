// SPDX-License-Identifier: GPL-3.0-or-later
// Do the methods of one answer contradict each other?
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace blockweir::study {

/// `answer`: content of reliability.json. Names the two methods whose probabilities are farthest apart if the ranges
/// that they give are apart more than tenfold; else empty.
std::string contradiction_of(const nlohmann::json& answer);

}  // namespace blockweir::study
