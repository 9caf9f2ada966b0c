// SPDX-License-Identifier: GPL-3.0-or-later
// [[random]], [[correlation]] and [reliability]: what is uncertain in a scene, and how the probability of its failure
// is to be found. No run of the scene needs them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/distribution.hpp"

namespace blockweir::scene {

/// A number of the scene that is not known, but for its distribution.
struct RandomVariable {
  std::string name;
  std::string key;               ///< of the scene; empty: `set` says where the number goes
  std::vector<std::string> set;  ///< "key=value" each, with {NAME} in place of the number
  Distribution distribution;
  int line = 0;  ///< where the scene file states it
  bool operator==(const RandomVariable&) const = default;
};

/// Of the normal variables that stand behind two of them (Nataf's transformation, a normal copula).
struct Correlation {
  std::array<std::string, 2> between;
  double coefficient = 0;
  int line = 0;
  bool operator==(const Correlation&) const = default;
};

/// How the level at which a sample fails is found: limit analysis, static analysis of its blocks, a whole run.
enum class CapacityBy { limit, statics, runs };

struct Reliability {
  CapacityBy by = CapacityBy::limit;
  std::optional<double> level_m;         ///< of the reservoir, whose probability is asked for; the run's end by default
  std::string sampling = "monte-carlo";  ///< or latin-hypercube, quasi-random
  int samples = 1000;
  int seed = 1;                                       ///< the same seed draws the same values
  std::vector<std::string> methods{"form", "sobol"};  ///< beside the samples; also sorm, importance, subset
  int method_samples = 1000;                          ///< of each other method that draws
  bool operator==(const Reliability&) const = default;
};

struct Randomness {
  std::vector<RandomVariable> variables;
  std::vector<Correlation> correlations;
  Reliability reliability;
  int line = 0;  ///< of [reliability]; 0: the scene has none
  bool operator==(const Randomness&) const = default;
};

}  // namespace blockweir::scene
