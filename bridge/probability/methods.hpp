// SPDX-License-Identifier: GPL-3.0-or-later
// Probability that a function of random variables is below a threshold, by OpenTURNS.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <openturns/Distribution.hxx>

namespace blockweir::probability {

/// Values of the function at points, in their order.
using Evaluate = std::function<OT::Sample(const OT::Sample& points)>;

/// First and second order reliability method, started at the means: "probability", "index", "design_point",
/// "importance" of each variable, "evaluations", and "residual", the distance of the design point from the threshold.
nlohmann::json form(const OT::Distribution& joint, const Evaluate& evaluate, double threshold, bool second_order);

/// Importance sampling about the design point.
nlohmann::json importance_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold,
                                   unsigned samples);

/// Subset sampling with `samples` in each level.
nlohmann::json subset_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold,
                               unsigned samples);

/// Sobol's indices of the function, "first" and "total" with confidence intervals, by Martinez' estimators from
/// `samples` (d + 2) points. For independent variables only.
nlohmann::json sobol(const OT::Distribution& joint, const Evaluate& evaluate, unsigned samples);

}  // namespace blockweir::probability
