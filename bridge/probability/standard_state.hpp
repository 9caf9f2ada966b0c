// SPDX-License-Identifier: GPL-3.0-or-later
// The function and its threshold in the space of independent standard normal variables. Steps of a search are taken
// there: none leaves a distribution.
#pragma once

#include <functional>
#include <openturns/ComparisonOperator.hxx>
#include <openturns/Distribution.hxx>
#include <openturns/ThresholdEvent.hxx>
#include <stdexcept>

namespace blockweir::probability {

/// Values of the function at points, in their order; NaN where there is none.
using Evaluate = std::function<OT::Sample(const OT::Sample& points)>;

/// A method needs the value at a point that has none.
struct Unanswered : std::runtime_error {
  explicit Unanswered(OT::Point point) : std::runtime_error("a point has no value"), at(std::move(point)) {}
  OT::Point at;  ///< of the variables themselves
};

class StandardState {
 public:
  /// `evaluate` must outlive the object.
  StandardState(const OT::Distribution& joint, const Evaluate& evaluate, double threshold);

  [[nodiscard]] OT::UnsignedInteger dimension() const { return joint_.getDimension(); }
  [[nodiscard]] double threshold() const { return threshold_; }
  /// The variables' values at a standard point.
  [[nodiscard]] OT::Point physical(const OT::Point& standard) const { return to_physical_(standard); }
  /// Phi^-1(F_i(x_i)) of each variable: the standard point itself where they are independent.
  [[nodiscard]] OT::Point each_alone(const OT::Point& standard) const;
  /// Values of the function at standard points; NaN where there is none.
  [[nodiscard]] OT::Sample values(const OT::Sample& standard) const { return evaluate_(to_physical_(standard)); }
  double value(const OT::Point& standard) const;
  /// That the value compares so with the threshold. Evaluations throw Unanswered.
  [[nodiscard]] OT::ThresholdEvent event(const OT::ComparisonOperator& holds) const;

 private:
  OT::Distribution joint_;
  OT::Function to_physical_;
  const Evaluate& evaluate_;
  double threshold_;
};

}  // namespace blockweir::probability
