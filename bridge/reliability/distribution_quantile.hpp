// SPDX-License-Identifier: GPL-3.0-or-later
// The value that a share of a distribution's values lies below.
#pragma once

#include "bridge/scene/distribution.hpp"

namespace blockweir::study {

/// `probability`: between 0 and 1, neither of them. Of measured values, which a distribution is fitted to: their own.
double quantile_of(const scene::Distribution& distribution, double probability);

}  // namespace blockweir::study
