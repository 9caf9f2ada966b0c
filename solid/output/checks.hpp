// SPDX-License-Identifier: GPL-3.0-or-later
// The figures that a case states, each beside what the run gave.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// A list of name, expected, got, relative_error, tolerance, passed, formula and source; of a figure that the run
/// cannot give also `trouble`, or `why_none`.
nlohmann::json checks(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
