// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of kind = "critical" as a picture.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/open_study.hpp"
#include "bridge/study/open_study.hpp"

namespace blockweir::study {

/// gnuplot's commands: over the value of the key the factor with its target, or without a factor each run's outcome;
/// and a line at the value that was found.
std::string critical_figure(const scene::CriticalValue& critical, const std::vector<Outcome>& runs, double found);

}  // namespace blockweir::study
