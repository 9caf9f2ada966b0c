// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/probability/methods.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <openturns/AbdoRackwitz.hxx>
#include <openturns/DistFunc.hxx>
#include <openturns/Exception.hxx>
#include <openturns/GreaterOrEqual.hxx>
#include <openturns/ImportanceSamplingExperiment.hxx>
#include <openturns/Less.hxx>
#include <openturns/MartinezSensitivityAlgorithm.hxx>
#include <openturns/Mixture.hxx>
#include <openturns/Normal.hxx>
#include <openturns/ProbabilitySimulationAlgorithm.hxx>
#include <openturns/SORM.hxx>
#include <openturns/SobolIndicesExperiment.hxx>
#include <openturns/SubsetSampling.hxx>
#include <optional>

#include "bridge/probability/design_points.hpp"

namespace blockweir::probability {
namespace {

using nlohmann::json;

std::vector<double> numbers(const OT::Point& point) {
  return {point.begin(), point.end()};
}

/// P = Phi(-beta), below 0 where the means fail. OpenTURNS' own index ends at 7.65.
double probability_of(double index) {
  return OT::DistFunc::pNormal(index, /*tail=*/true);
}
json index_of(double probability) {
  if (!(probability > 0 && probability < 1)) return {};
  return OT::DistFunc::qNormal(probability, /*tail=*/true);
}

json simulated(const OT::ProbabilitySimulationResult& result) {
  const double probability = result.getProbabilityEstimate();
  const double half = result.getConfidenceLength(0.95) / 2;
  return {{"probability", probability},
          {"interval", {std::max(0.0, probability - half), std::min(1.0, probability + half)}},
          {"coefficient_of_variation", result.getCoefficientOfVariation()},
          {"evaluations", result.getOuterSampling() * result.getBlockSize()}};
}

json complement(json answer) {
  const double probability = answer["probability"];
  const double share = probability > 0 ? probability / (1 - probability) : 0;
  answer["probability"] = 1 - probability;
  answer["interval"] = {1 - answer["interval"][1].get<double>(), 1 - answer["interval"][0].get<double>()};
  answer["coefficient_of_variation"] = answer["coefficient_of_variation"].get<double>() * share;
  return answer;
}

/// Shares of y^2 in |y|^2.
OT::Point importance_of(const OT::Point& y) {
  OT::Point shares(y.getDimension());
  for (OT::UnsignedInteger i = 0; i < y.getDimension(); ++i) shares[i] = y[i] * y[i] / y.normSquare();
  return shares;
}

/// The variables that matter at the design point and do not change the value at the means.
json without_effect(const StandardState& state, const OT::Point& importance) {
  constexpr double step = 1e-3;
  constexpr double matters = 0.01;
  constexpr double rounding = 1e-10;
  json found = json::array();
  for (unsigned i = 0; i < state.dimension(); ++i) {
    OT::Point at(state.dimension());
    at[i] = step;
    if (importance[i] < matters) continue;
    const double value = state.value(at);
    if (std::abs(value - state.value(-1.0 * at)) <= rounding * std::abs(value)) found.push_back(i);
  }
  return found;
}

json point_json(const StandardState& state, const DesignPoint& point) {
  return {{"probability", probability_of(point.index)},
          {"index", point.index},
          {"design_point", numbers(state.physical(point.standard))}};
}

/// As many points about each design point.
OT::Distribution about(const DesignPoints& points) {
  OT::Collection<OT::Distribution> all;
  for (const DesignPoint& point : points.all) {
    const OT::UnsignedInteger dimension = point.standard.getDimension();
    all.add(OT::Normal(point.standard, OT::Point(dimension, 1), OT::CorrelationMatrix(dimension)));
  }
  return OT::Mixture(all);
}

std::optional<DesignPoints> design_points_if_any(const StandardState& state) {
  try {
    return design_points(state);
  } catch (const OT::Exception&) {
    return std::nullopt;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

json sampled_about(const DesignPoints& points, const StandardState& state, unsigned samples) {
  // About the design point half of the points would not say where the rest of a large probability is.
  const OT::ThresholdEvent event = state.event(points.means_fail ? OT::ComparisonOperator(OT::GreaterOrEqual())
                                                                 : OT::ComparisonOperator(OT::Less()));
  const OT::ImportanceSamplingExperiment experiment(OT::Normal(state.dimension()), about(points), samples);
  OT::ProbabilitySimulationAlgorithm sampling(event, experiment);
  sampling.setBlockSize(samples);
  sampling.setMaximumOuterSampling(1);
  sampling.setMaximumCoefficientOfVariation(0);
  sampling.run();
  const json answer = simulated(sampling.getResult());
  return points.means_fail ? complement(answer) : answer;
}

/// False if its probability gets below the least that is looked for.
bool ends(OT::SubsetSampling& sampling) {
  try {
    sampling.run();
    return true;
  } catch (const OT::Exception& error) {
    if (std::string(error.what()).find("Probability estimate too small") == std::string::npos) throw;
    return false;
  }
}

[[noreturn]] void refuse_missed(const StandardState& state, const DesignPoint& point) {
  throw std::runtime_error(
      fmt::format("its points miss the design point ({:.6g}), whose P is {:.3g}: at higher levels "
                  "other points fail "
                  "first; ask \"importance\", or raise method_samples",
                  fmt::join(numbers(state.physical(point.standard)), ", "), probability_of(point.index)));
}

}  // namespace

json form(const OT::Distribution& joint, const Evaluate& evaluate, double threshold, bool second_order) {
  const StandardState state(joint, evaluate, threshold);
  const DesignPoints points = design_points(state);
  const DesignPoint& nearest = points.all.front();
  const OT::Point importance = importance_of(state.each_alone(nearest.standard));
  json answer = point_json(state, nearest);
  answer["importance"] = numbers(importance);
  answer["iterations"] = nearest.iterations;
  answer["residual"] = nearest.residual;
  answer["without_effect_at_means"] = without_effect(state, importance);
  answer["further"] = json::array();
  double sum = probability_of(nearest.index);
  for (std::size_t i = 1; i < points.all.size() && !points.means_fail; ++i) {
    answer["further"].push_back(point_json(state, points.all[i]));
    sum += probability_of(points.all[i].index);
  }
  answer["at_most"] = std::min(1.0, sum);
  if (!second_order) return answer;
  OT::SORM analysis(OT::AbdoRackwitz(), state.event(OT::Less()), nearest.standard);
  analysis.run();
  const double probability = analysis.getResult().getEventProbabilityBreitung();
  answer["breitung"] = {{"probability", probability}, {"index", index_of(probability)}};
  return answer;
}

json importance_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold, unsigned samples) {
  const StandardState state(joint, evaluate, threshold);
  const DesignPoints points = design_points(state);
  return sampled_about(points, state, samples);
}

json subset_sampling(const OT::Distribution& joint, const Evaluate& evaluate, double threshold, unsigned samples) {
  constexpr unsigned block = 100;
  constexpr double rarest = 1e-20;
  constexpr double too_rare = 1e-3;
  double highest = -std::numeric_limits<double>::infinity();
  const Evaluate watched = [&](const OT::Sample& points) {
    OT::Sample values = evaluate(points);
    highest = std::max(highest, values.getMax()[0]);
    return values;
  };
  const StandardState state(joint, watched, threshold);
  const std::optional<DesignPoints> points = design_points_if_any(state);
  const double expected = points ? probability_of(points->all.front().index) : 0;
  const double least = std::max(rarest, too_rare * expected);
  OT::SubsetSampling sampling(state.event(OT::Less()));
  sampling.setBlockSize(std::min(block, samples));
  sampling.setMaximumOuterSampling(std::max(1U, samples / block));
  sampling.setMinimumProbability(least);
  sampling.setKeepEventSample(true);
  const bool ended = ends(sampling);
  const OT::Point levels = sampling.getThresholdPerStep();
  // Each threshold is taken to have a tenth of the points below it.
  if (levels[0] >= highest) {
    throw std::runtime_error(
        "more than nine tenths of the points stand at the highest level that is looked at, and none of these is known "
        "to be nearer to failing than another; ask \"importance\", or look for higher levels with may_overtop = true "
        "in [water]");
  }
  if (!ended && expected > rarest) refuse_missed(state, points->all.front());
  if (!ended) {
    throw std::runtime_error(fmt::format(
        "none of its points fails, down to P = {}; expected a level at which failure is likelier; raise level_m",
        rarest));
  }
  json answer = simulated(sampling.getResult());
  // A way to fail that it comes to late has too small a P: importance sampling knows curved boundaries, too.
  constexpr double surely = 2;
  const double at_most = surely * answer["interval"][1].get<double>();
  if (expected > at_most && sampled_about(*points, state, samples)["interval"][0] > at_most) {
    refuse_missed(state, points->all.front());
  }
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
