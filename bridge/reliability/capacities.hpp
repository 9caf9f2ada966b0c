// SPDX-License-Identifier: GPL-3.0-or-later
// The levels at which samples of a scene fail, and how likely it is that one fails at a level or below.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/study/outcome_work.hpp"

namespace blockweir::study {

/// Of one sample: the level at which it fails; -infinite where it does not stand at all, +infinite where it stands at
/// the highest level, NaN where there is no answer.
double capacity_of(const Outcome& row);

/// A share of samples with the interval that holds the true share in 95 of 100 ensembles.
struct Share {
  double value = 0;
  double from = 0;
  double to = 1;
};

class Capacities {
 public:
  /// `groups`: as many designs of one size, each drawn by itself; 1: all samples are independent.
  Capacities(std::vector<double> levels_m, std::size_t groups) : levels_m_(std::move(levels_m)), groups_(groups) {}

  /// That fail at a level or below. Independent samples: by Clopper and Pearson; groups: by Student's t over their
  /// shares, or as if independent where no group differs. Samples without an answer widen the interval: all fail, or
  /// none.
  [[nodiscard]] Share failing(double level_m) const;

  /// Failures at some level, in rising order.
  [[nodiscard]] std::vector<double> finite() const;
  [[nodiscard]] std::size_t size() const { return levels_m_.size(); }
  [[nodiscard]] std::size_t without_answer() const;
  [[nodiscard]] std::size_t that_stand() const;
  [[nodiscard]] std::size_t that_never_stand() const;

  /// The fragility curve: levels over all failures, with shares.
  [[nodiscard]] nlohmann::json curve() const;

 private:
  std::vector<double> levels_m_;
  std::size_t groups_;
};

/// beta with P = Phi(-beta).
double reliability_index(double probability);

}  // namespace blockweir::study
