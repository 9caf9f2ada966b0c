// SPDX-License-Identifier: GPL-3.0-or-later
// What OpenTURNS finds of the event that a function of random variables is below a threshold.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <openturns/Distribution.hxx>

namespace blockweir::probability {

/// Values of the function at points, in their order.
using Evaluate = std::function<OT::Sample(const OT::Sample& points)>;

/// First and second order reliability method from the means on: "probability", "index", "design_point", "importance"
/// of each variable, "evaluations", and "residual": what the design point is off the threshold.
nlohmann::json form(const OT::Distribution& joint, const Evaluate& evaluate, double threshold, bool second_order);

/// Importance sampling about the design point.
nlohmann::json importance_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold,
                                   unsigned samples);

/// Subset sampling; `samples` at each level.
nlohmann::json subset_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold,
                               unsigned samples);

/// Sobol's indices of the function, "first" and "total" with their intervals, by Martinez' estimators from
/// `samples` (d + 2) points. Of independent variables alone.
nlohmann::json sobol(const OT::Distribution& joint, const Evaluate& evaluate, unsigned samples);

}  // namespace blockweir::probability
