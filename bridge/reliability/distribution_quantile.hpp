// SPDX-License-Identifier: GPL-3.0-or-later
// Quantiles of a distribution.
#pragma once

#include "bridge/scene/distribution.hpp"

namespace blockweir::study {

/// `probability`: between 0 and 1, both excluded. For a fitted distribution: the quantile of the measured values.
double quantile_of(const scene::Distribution& distribution, double probability);

}  // namespace blockweir::study
