// SPDX-License-Identifier: GPL-3.0-or-later
// Probability that a function of random variables is below a threshold, by OpenTURNS.
#pragma once

#include <nlohmann/json.hpp>
#include <openturns/Distribution.hxx>

#include "bridge/probability/standard_state.hpp"

namespace blockweir::probability {

/// First and second order reliability method: "probability", "index", "design_point", "importance" of each variable,
/// and "residual", the distance of the design point from the threshold. "further": design points nearly as likely;
/// "at_most": the sum of all their probabilities. "without_effect_at_means": the variables that matter at the design
/// point and change nothing at the means.
nlohmann::json form(const OT::Distribution& joint, const Evaluate& evaluate, double threshold, bool second_order);

/// Importance sampling about all design points.
nlohmann::json importance_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold,
                                   unsigned samples);

/// Subset sampling with `samples` in each level. Throws std::runtime_error if its points miss a likelier design point.
nlohmann::json subset_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold,
                               unsigned samples);

/// Sobol's indices of the function, "first" and "total" with confidence intervals, by Martinez' estimators from
/// `samples` (d + 2) points. For independent variables only.
nlohmann::json sobol(const OT::Distribution& joint, const Evaluate& evaluate, unsigned samples);

}  // namespace blockweir::probability
