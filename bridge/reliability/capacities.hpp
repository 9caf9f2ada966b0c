// SPDX-License-Identifier: GPL-3.0-or-later
// The levels at which samples of a scene fail, and the probability of failure at a level or below.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "bridge/study/outcome_work.hpp"

namespace blockweir::study {

/// Failure level of a sample; -infinite if it is never stable, +infinite if it is stable at the highest level, NaN if
/// there is no answer.
double capacity_of(const Outcome& row);

/// A share of samples with its 95 % confidence interval.
struct Share {
  double value = 0;
  double from = 0;
  double to = 1;
};

class Capacities {
 public:
  /// `groups`: number of independent designs of equal size; 1: all samples are independent.
  Capacities(std::vector<double> levels_m, std::size_t groups) : levels_m_(std::move(levels_m)), groups_(groups) {}

  /// Share that fails at a level or below. Confidence interval of independent samples: Clopper and Pearson; of groups:
  /// Student's t over their shares, or as if independent if no group differs. Samples without an answer widen the
  /// interval: all of them fail, or none.
  [[nodiscard]] Share failing(double level_m) const;

  /// Levels of the samples that fail at some level, ascending.
  [[nodiscard]] std::vector<double> finite() const;
  /// The level, to five digits, that most of those have, and how many; there is one at least.
  [[nodiscard]] std::pair<double, std::size_t> commonest() const;
  [[nodiscard]] std::size_t size() const { return levels_m_.size(); }
  [[nodiscard]] std::size_t without_answer() const;
  [[nodiscard]] std::size_t that_stand() const;
  [[nodiscard]] std::size_t that_never_stand() const;

  /// The fragility curve: levels over the range of failures, with shares.
  [[nodiscard]] nlohmann::json curve() const;

 private:
  std::vector<double> levels_m_;
  std::size_t groups_;
};

/// beta with P = Phi(-beta).
double reliability_index(double probability);

}  // namespace blockweir::study
