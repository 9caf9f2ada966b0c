// SPDX-License-Identifier: GPL-3.0-or-later
// How a dam on a bed of rock fails with its rock, where that is known by hand.
#pragma once

#include <optional>

#include "tests/independent/limit_analysis.hpp"
#include "tests/independent/limit_equilibrium.hpp"

namespace blockweir::independent {

/// Of bodies ground, rock and dam in this order, joints contact and bedding: rock and dam turn over the end of the
/// bedding, or slide on it at a level at which the mechanism of limit analysis does not turn the rock.
std::optional<Failing> failing_on_rock(const Structure& structure, const Limit& limit, double high_m);

}  // namespace blockweir::independent
