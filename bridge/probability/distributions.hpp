// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's random variables as a joint distribution of OpenTURNS, and points drawn from it.
#pragma once

#include <nlohmann/json.hpp>
#include <openturns/Distribution.hxx>
#include <openturns/Sample.hxx>
#include <string>

namespace blockweir::probability {

/// Members of `request`: "variables", each as in [[random]], and "correlations", each {"i", "j", "coefficient"}, of the
/// corresponding normal variables (normal copula). Throws std::exception for invalid parameters.
OT::Distribution joint_distribution(const nlohmann::json& request);

/// `count` points by "monte-carlo", "latin-hypercube" or "quasi-random".
OT::Sample draw(const OT::Distribution& joint, const std::string& sampling, unsigned count);

/// The best fit to the values (Bayesian information criterion) among normal, lognormal, uniform and triangular
/// distributions.
OT::Distribution fitted(const OT::Sample& values);

}  // namespace blockweir::probability
