// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/probability/standard_state.hpp"

#include <cmath>
#include <openturns/CenteredFiniteDifferenceGradient.hxx>
#include <openturns/CenteredFiniteDifferenceHessian.hxx>
#include <openturns/CompositeRandomVector.hxx>
#include <openturns/EvaluationImplementation.hxx>
#include <openturns/Normal.hxx>

namespace blockweir::probability {
namespace {

/// The function as OpenTURNS calls it.
class Evaluations : public OT::EvaluationImplementation {
 public:
  Evaluations(OT::Function to_physical, const Evaluate& evaluate)
      : to_physical_(std::move(to_physical)), evaluate_(evaluate) {}
  Evaluations* clone() const override { return new Evaluations(*this); }
  OT::Point operator()(const OT::Point& at) const override { return (*this)(OT::Sample(1, at))[0]; }
  OT::Sample operator()(const OT::Sample& points) const override {
    const OT::Sample physical = to_physical_(points);
    OT::Sample values = evaluate_(physical);
    for (OT::UnsignedInteger i = 0; i < values.getSize(); ++i) {
      if (std::isnan(values(i, 0))) throw Unanswered(physical[i]);
    }
    return values;
  }
  OT::UnsignedInteger getInputDimension() const override { return to_physical_.getInputDimension(); }
  OT::UnsignedInteger getOutputDimension() const override { return 1; }

 private:
  OT::Function to_physical_;
  const Evaluate& evaluate_;
};

}  // namespace

StandardState::StandardState(const OT::Distribution& joint, const Evaluate& evaluate, double threshold)
    : joint_(joint),
      to_physical_(joint.getInverseIsoProbabilisticTransformation()),
      evaluate_(evaluate),
      threshold_(threshold) {}

OT::Point StandardState::each_alone(const OT::Point& standard) const {
  const OT::Point at = physical(standard);
  OT::Point alone(dimension());
  for (OT::UnsignedInteger i = 0; i < dimension(); ++i) {
    alone[i] = joint_.getMarginal(i).getIsoProbabilisticTransformation()(OT::Point(1, at[i]))[0];
  }
  return alone;
}

double StandardState::value(const OT::Point& standard) const {
  return values(OT::Sample(1, standard))(0, 0);
}

OT::ThresholdEvent StandardState::event(const OT::ComparisonOperator& holds) const {
  constexpr double step = 1e-3;  // of a deviation: OpenTURNS' own steps are lengths
  const OT::Evaluation evaluation(Evaluations(to_physical_, evaluate_));
  const OT::Point steps(dimension(), step);
  OT::Function function(evaluation);
  function.setGradient(OT::CenteredFiniteDifferenceGradient(steps, evaluation));
  function.setHessian(OT::CenteredFiniteDifferenceHessian(steps, evaluation));
  return OT::ThresholdEvent(OT::CompositeRandomVector(function, OT::RandomVector(OT::Normal(dimension()))), holds,
                            threshold_);
}

}  // namespace blockweir::probability
