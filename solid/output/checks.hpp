// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the figures that a case states with those of the run.
#pragma once

#include <nlohmann/json.hpp>

#include "solid/expect/quantities.hpp"

namespace blockweir::solid::output {

/// A list of name, expected, got, relative_error, tolerance, passed, formula and source; for a figure that the run does
/// not have also `trouble` or `why_none`.
nlohmann::json checks(const expect::Outcome& outcome);

}  // namespace blockweir::solid::output
