// SPDX-License-Identifier: GPL-3.0-or-later
// The program blockweir-probability, which draws points and evaluates probabilities by OpenTURNS, and the settings that
// a point of the random variables stands for.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/process/line_program.hpp"
#include "bridge/scene/randomness.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// A value of each variable.
using RandomPoint = std::vector<double>;

class Probability {
 public:
  /// Values of a function at points.
  using Evaluate = std::function<std::vector<double>(const std::vector<RandomPoint>& points)>;

  explicit Probability(const scene::Randomness& randomness);
  /// Of variables that do not depend on each other.
  Probability(const std::vector<scene::Distribution>& distributions, int seed);

  /// What the program answers to `request` ("do", and what that needs). Throws std::runtime_error with its reason where
  /// it has none.
  nlohmann::json ask(nlohmann::json request, const Evaluate& evaluate = {});

 private:
  nlohmann::json common_;
  std::unique_ptr<process::LineProgram> program_;
};

/// What the scene is set to by variable `v` alone. Throws std::out_of_range where there is none.
Settings settings_of_one(const scene::Randomness& randomness, std::size_t v, const RandomPoint& point);

/// What the scene is set to where the variables have these values.
Settings settings_of(const scene::Randomness& randomness, const RandomPoint& point);

}  // namespace blockweir::study
