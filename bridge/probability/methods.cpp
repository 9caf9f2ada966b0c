// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/probability/methods.hpp"

#include <openturns/AbdoRackwitz.hxx>
#include <openturns/CenteredFiniteDifferenceGradient.hxx>
#include <openturns/CenteredFiniteDifferenceHessian.hxx>
#include <openturns/CompositeRandomVector.hxx>
#include <openturns/EvaluationImplementation.hxx>
#include <openturns/Exception.hxx>
#include <openturns/FORM.hxx>
#include <openturns/GreaterOrEqual.hxx>
#include <openturns/Less.hxx>
#include <openturns/MartinezSensitivityAlgorithm.hxx>
#include <openturns/Normal.hxx>
#include <openturns/PostAnalyticalImportanceSampling.hxx>
#include <openturns/SORM.hxx>
#include <openturns/SobolIndicesExperiment.hxx>
#include <openturns/SubsetSampling.hxx>
#include <openturns/ThresholdEvent.hxx>

#include <limits>

namespace blockweir::probability {
namespace {

using nlohmann::json;

/// The function as OpenTURNS calls it.
class Evaluations : public OT::EvaluationImplementation {
 public:
  Evaluations(OT::UnsignedInteger inputs, const Evaluate& evaluate) : inputs_(inputs), evaluate_(evaluate) {}
  Evaluations* clone() const override { return new Evaluations(*this); }
  OT::Point operator()(const OT::Point& at) const override {
    OT::Sample one(0, at.getDimension());
    one.add(at);
    return evaluate_(one)[0];
  }
  OT::Sample operator()(const OT::Sample& points) const override { return evaluate_(points); }
  OT::UnsignedInteger getInputDimension() const override { return inputs_; }
  OT::UnsignedInteger getOutputDimension() const override { return 1; }

 private:
  OT::UnsignedInteger inputs_;
  const Evaluate& evaluate_;
};

/// Its derivatives by differences over a thousandth of each variable's deviation: OpenTURNS' own steps are lengths.
OT::Function function_of(const OT::Distribution& joint, const Evaluate& evaluate) {
  constexpr double step = 1e-3;
  const OT::Evaluation evaluation(Evaluations(joint.getDimension(), evaluate));
  const OT::Point steps = step * joint.getStandardDeviation();
  OT::Function function(evaluation);
  function.setGradient(OT::CenteredFiniteDifferenceGradient(steps, evaluation));
  function.setHessian(OT::CenteredFiniteDifferenceHessian(steps, evaluation));
  return function;
}

OT::ThresholdEvent event_of(const OT::Distribution& joint, const Evaluate& evaluate, double threshold,
                            const OT::ComparisonOperator& holds = OT::Less()) {
  const OT::RandomVector inputs(joint);
  return OT::ThresholdEvent(OT::CompositeRandomVector(function_of(joint, evaluate), inputs), holds, threshold);
}

OT::AbdoRackwitz nearest_point() {
  constexpr unsigned most_iterations = 100;
  OT::AbdoRackwitz algorithm;
  algorithm.setMaximumIterationNumber(most_iterations);
  algorithm.setMaximumAbsoluteError(1e-8);
  algorithm.setMaximumRelativeError(1e-8);
  algorithm.setMaximumResidualError(1e-8);
  algorithm.setMaximumConstraintError(1e-8);
  return algorithm;
}

std::vector<double> numbers(const OT::Point& point) {
  return {point.begin(), point.end()};
}

json simulated(const OT::ProbabilitySimulationResult& result) {
  const double probability = result.getProbabilityEstimate();
  const double half = result.getConfidenceLength(0.95) / 2;
  return {{"probability", probability},
          {"interval", {std::max(0.0, probability - half), std::min(1.0, probability + half)}},
          {"coefficient_of_variation", result.getCoefficientOfVariation()},
          {"evaluations", result.getOuterSampling() * result.getBlockSize()}};
}

bool ends_on_level_ground(const OT::Exception& error) {
  return std::string(error.what()).find("gradient of the level function is zero") != std::string::npos;
}

/// Which of these points have a lower level than the means? A structure that the means fill to its crest has the same
/// level all around them.
std::vector<OT::Point> on_slopes(const OT::ThresholdEvent& event, const OT::Distribution& joint, OT::Sample points) {
  points.add(joint.getMean());
  const OT::Sample levels = event.getFunction()(points);
  const OT::UnsignedInteger last = points.getSize() - 1;
  std::vector<OT::Point> found;
  for (OT::UnsignedInteger i = 0; i < last; ++i) {
    if (levels(i, 0) < levels(last, 0)) found.push_back(points[i]);
  }
  return found;
}

/// Both ways along each axis of standard space, so many deviations from its origin.
OT::Sample along_axes(const OT::Distribution& joint, double deviations) {
  const auto to_physical = joint.getInverseIsoProbabilisticTransformation();
  OT::Sample points(0, joint.getDimension());
  for (OT::UnsignedInteger axis = 0; axis < joint.getDimension(); ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      OT::Point at(joint.getDimension());
      at[axis] = sign * deviations;
      points.add(to_physical(at));
    }
  }
  return points;
}

/// Throws OT::Exception where the search from `start` does not end.
template <class Analysis>
auto analysed_from(const OT::Point& start, const OT::ThresholdEvent& event) {
  Analysis analysis(nearest_point(), event, start);
  analysis.run();
  return analysis.getResult();
}

/// From the means; where these lie on level ground, from the nearest points off it along the axes, or among draws.
template <class Analysis>
auto analysed(const OT::ThresholdEvent& event, const OT::Distribution& joint) {
  constexpr double step = 0.5;  // in deviations
  constexpr int steps = 12;
  constexpr unsigned draws = 200;
  constexpr std::size_t most_starts = 4;  // of each ring, and of the draws
  std::vector<OT::Point> starts{joint.getMean()};
  for (int k = 1;; ++k) {
    starts.resize(std::min(starts.size(), most_starts));
    for (const OT::Point& start : starts) {
      try {
        return analysed_from<Analysis>(start, event);
      } catch (const OT::Exception& error) {
        if (!ends_on_level_ground(error)) throw;
      }
    }
    if (k > steps + 1) break;
    starts = on_slopes(event, joint, k <= steps ? along_axes(joint, k * step) : joint.getSample(draws));
  }
  throw std::runtime_error(
      "the search for the design point reached a point at which no variable changes the level; "
      "expected one at which they do; state methods = [\"subset\"], which needs no such point");
}

/// beta with P = Phi(-beta), below 0 where the means fail.
double index_of(double probability) {
  return -OT::Normal().computeQuantile(probability)[0];
}

json complement(json answer) {
  const double probability = answer["probability"];
  const double share = probability > 0 ? probability / (1 - probability) : 0;
  answer["probability"] = 1 - probability;
  answer["interval"] = {1 - answer["interval"][1].get<double>(), 1 - answer["interval"][0].get<double>()};
  answer["coefficient_of_variation"] = answer["coefficient_of_variation"].get<double>() * share;
  return answer;
}

}  // namespace

json form(const OT::Distribution& joint, const Evaluate& evaluate, double threshold, bool second_order) {
  const OT::ThresholdEvent event = event_of(joint, evaluate, threshold);
  const OT::FORMResult first = analysed<OT::FORM>(event, joint);
  const OT::Point design = first.getPhysicalSpaceDesignPoint();
  OT::Sample at_design(0, joint.getDimension());
  at_design.add(design);
  json answer = {{"probability", first.getEventProbability()},
                 {"index", index_of(first.getEventProbability())},
                 {"design_point", numbers(design)},
                 {"importance", numbers(first.getImportanceFactors())},
                 {"iterations", first.getOptimizationResult().getIterationNumber()},
                 {"residual", evaluate(at_design)(0, 0) - threshold}};
  if (!second_order) return answer;
  const OT::SORMResult second = analysed<OT::SORM>(event, joint);
  answer["breitung"] = {{"probability", second.getEventProbabilityBreitung()},
                        {"index", index_of(second.getEventProbabilityBreitung())}};
  return answer;
}

json importance_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold, unsigned samples) {
  OT::FORMResult design = analysed<OT::FORM>(event_of(joint, evaluate, threshold), joint);
  // About the design point half of the points would not say where the rest of a large probability is.
  const bool means_fail = design.getIsStandardPointOriginInFailureSpace();
  if (means_fail) design = analysed<OT::FORM>(event_of(joint, evaluate, threshold, OT::GreaterOrEqual()), joint);
  OT::PostAnalyticalImportanceSampling sampling(design);
  sampling.setBlockSize(samples);
  sampling.setMaximumOuterSampling(1);
  sampling.setMaximumCoefficientOfVariation(0);
  sampling.run();
  const json answer = simulated(sampling.getResult());
  return means_fail ? complement(answer) : answer;
}

json subset_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold, unsigned samples) {
  constexpr unsigned block = 100;
  double highest = -std::numeric_limits<double>::infinity();
  const Evaluate watched = [&](const OT::Sample& points) {
    OT::Sample values = evaluate(points);
    highest = std::max(highest, values.getMax()[0]);
    return values;
  };
  const OT::ThresholdEvent event = event_of(joint, watched, threshold);
  OT::SubsetSampling sampling(event);
  sampling.setBlockSize(std::min(block, samples));
  sampling.setMaximumOuterSampling(std::max(1U, samples / block));
  sampling.run();
  const OT::Point levels = sampling.getThresholdPerStep();
  // Each threshold is taken to have a tenth of the points below it.
  if (levels[0] >= highest) {
    throw std::runtime_error(
        "more than nine tenths of the points stand at the highest level that is looked at, and none of these is known "
        "to be nearer to failing than another; ask \"importance\", or look for higher levels with may_overtop = true "
        "in [water]");
  }
  json answer = simulated(sampling.getResult());
  answer["levels"] = numbers(levels);
  return answer;
}

json sobol(const OT::Distribution& joint, const Evaluate& evaluate, unsigned samples) {
  const OT::Sample design = OT::SobolIndicesExperiment(joint, samples, /*computeSecondOrder=*/false).generate();
  OT::MartinezSensitivityAlgorithm indices(design, evaluate(design), samples);
  indices.setUseAsymptoticDistribution(true);
  const OT::Interval first = indices.getFirstOrderIndicesInterval();
  const OT::Interval total = indices.getTotalOrderIndicesInterval();
  return {{"first", numbers(indices.getFirstOrderIndices())},
          {"first_from", numbers(first.getLowerBound())},
          {"first_to", numbers(first.getUpperBound())},
          {"total", numbers(indices.getTotalOrderIndices())},
          {"total_from", numbers(total.getLowerBound())},
          {"total_to", numbers(total.getUpperBound())},
          {"evaluations", design.getSize()}};
}

}  // namespace blockweir::probability
