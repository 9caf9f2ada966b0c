// SPDX-License-Identifier: GPL-3.0-or-later
// Calls the program blockweir-probability, which draws points and evaluates probabilities by OpenTURNS, and converts
// points of the random variables into settings.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/process/line_program.hpp"
#include "bridge/scene/randomness.hpp"
#include "bridge/study/study.hpp"

namespace blockweir::study {

/// One value for each variable.
using RandomPoint = std::vector<double>;

/// A method needs the function's value at a point that has none.
struct Unanswered : std::runtime_error {
  Unanswered(const std::string& reason, RandomPoint point) : std::runtime_error(reason), at(std::move(point)) {}
  RandomPoint at;
};

class Probability {
 public:
  /// Values of a function at points; NaN where there is none.
  using Evaluate = std::function<std::vector<double>(const std::vector<RandomPoint>& points)>;

  explicit Probability(const scene::Randomness& randomness);
  /// For independent variables.
  Probability(const std::vector<scene::Distribution>& distributions, int seed);

  /// The program's answer to `request` ("do", and what that needs). Throws std::runtime_error with the program's reason
  /// if there is none, Unanswered if a value is missing.
  nlohmann::json ask(nlohmann::json request, const Evaluate& evaluate = {});

 private:
  nlohmann::json common_;
  std::unique_ptr<process::LineProgram> program_;
};

/// Settings of the scene for variable `v` alone. Throws std::out_of_range if there is none.
Settings settings_of_one(const scene::Randomness& randomness, std::size_t v, const RandomPoint& point);

/// Settings of the scene for these values of all variables.
Settings settings_of(const scene::Randomness& randomness, const RandomPoint& point);

}  // namespace blockweir::study
