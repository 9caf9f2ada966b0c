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

/// What OpenTURNS says of a search that ends on level ground, in the words of who asked.
[[noreturn]] void fail_search(const OT::Exception& error) {
  if (std::string(error.what()).find("gradient of the level function is zero") == std::string::npos) throw;
  throw std::runtime_error("the search for the design point comes to a point at which no variable changes the level");
}

template <class Analysis>
auto analysed(const OT::ThresholdEvent& event, const OT::Distribution& joint) {
  Analysis analysis(nearest_point(), event, joint.getMean());
  try {
    analysis.run();
  } catch (const OT::Exception& error) {
    fail_search(error);
  }
  return analysis.getResult();
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
  const OT::ThresholdEvent event = event_of(joint, evaluate, threshold);
  OT::SubsetSampling sampling(event);
  sampling.setBlockSize(std::min(block, samples));
  sampling.setMaximumOuterSampling(std::max(1U, samples / block));
  sampling.run();
  json answer = simulated(sampling.getResult());
  answer["levels"] = numbers(sampling.getThresholdPerStep());
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
