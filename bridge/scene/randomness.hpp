// SPDX-License-Identifier: GPL-3.0-or-later
// [[random]], [[correlation]] and [reliability]: the uncertain numbers of a scene, and the methods that find its
// probability of failure. A single run does not need them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bridge/scene/distribution.hpp"

namespace blockweir::scene {

/// An uncertain number of the scene and its distribution.
struct RandomVariable {
  std::string name;
  std::string key;               ///< of the scene; empty: `set` states where the number is used
  std::vector<std::string> set;  ///< "key=value" each, where {NAME} stands for the number
  Distribution distribution;
  int line = 0;  ///< where the scene file states it
  bool operator==(const RandomVariable&) const = default;
};

/// Correlation of two variables after their transformation to normal ones (Nataf, normal copula).
struct Correlation {
  std::array<std::string, 2> between;
  double coefficient = 0;
  int line = 0;
  bool operator==(const Correlation&) const = default;
};

/// How the failure level of a sample is found: by limit analysis, by static analysis of the blocks, or by a whole run.
enum class CapacityBy { limit, statics, runs };

struct Reliability {
  CapacityBy by = CapacityBy::limit;
  std::optional<double> level_m;         ///< reservoir level of the probability; default: that of the run's end
  std::string sampling = "monte-carlo";  ///< or latin-hypercube, quasi-random
  int samples = 1000;
  int seed = 1;                                       ///< the same seed draws the same values
  std::vector<std::string> methods{"form", "sobol"};  ///< besides sampling; also sorm, importance, subset
  int method_samples = 1000;                          ///< of each further sampling method
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
