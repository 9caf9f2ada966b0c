// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/probability/distributions.hpp"

#include <openturns/ComposedDistribution.hxx>
#include <openturns/CorrelationMatrix.hxx>
#include <openturns/FittingTest.hxx>
#include <openturns/Histogram.hxx>
#include <openturns/LHSExperiment.hxx>
#include <openturns/LogNormal.hxx>
#include <openturns/LogNormalFactory.hxx>
#include <openturns/LogNormalMuSigma.hxx>
#include <openturns/LowDiscrepancyExperiment.hxx>
#include <openturns/Normal.hxx>
#include <openturns/NormalCopula.hxx>
#include <openturns/NormalFactory.hxx>
#include <openturns/ParametrizedDistribution.hxx>
#include <openturns/SobolSequence.hxx>
#include <openturns/Triangular.hxx>
#include <openturns/TriangularFactory.hxx>
#include <openturns/TruncatedDistribution.hxx>
#include <openturns/Uniform.hxx>
#include <openturns/UniformFactory.hxx>

namespace blockweir::probability {
namespace {

using nlohmann::json;

/// Linear between its rows: as many steps of an even density.
OT::Distribution of_table(const json& rows) {
  OT::Point widths;
  OT::Point heights;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double width = rows[i][0].get<double>() - rows[i - 1][0].get<double>();
    widths.add(width);
    heights.add((rows[i][1].get<double>() - rows[i - 1][1].get<double>()) / width);
  }
  return OT::Histogram(rows[0][0].get<double>(), widths, heights);
}

OT::Sample column(const json& values) {
  OT::Sample sample(0, 1);
  for (const json& value : values) sample.add(OT::Point(1, value.get<double>()));
  return sample;
}

OT::Distribution whole(const json& v) {
  const std::string kind = v["distribution"];
  const auto number = [&v](const char* key) { return v[key].get<double>(); };
  if (kind == "normal") return OT::Normal(number("mean"), number("deviation"));
  if (kind == "lognormal") {
    return OT::ParametrizedDistribution(OT::LogNormalMuSigma(number("mean"), number("deviation")));
  }
  if (kind == "uniform") return OT::Uniform(number("from"), number("to"));
  if (kind == "triangular") return OT::Triangular(number("from"), number("peak"), number("to"));
  if (kind == "table") return of_table(v["table"]);
  return fitted(column(v["values"]));
}

OT::Distribution cut_off(const OT::Distribution& distribution, const json& v) {
  const bool below = v["least"].is_number();
  const bool above = v["most"].is_number();
  if (below && above) {
    return OT::TruncatedDistribution(distribution, v["least"].get<double>(), v["most"].get<double>());
  }
  if (below) return OT::TruncatedDistribution(distribution, v["least"].get<double>(), OT::TruncatedDistribution::LOWER);
  if (above) return OT::TruncatedDistribution(distribution, v["most"].get<double>(), OT::TruncatedDistribution::UPPER);
  return distribution;
}

}  // namespace

OT::Distribution fitted(const OT::Sample& values) {
  OT::Collection<OT::DistributionFactory> candidates{OT::NormalFactory(), OT::UniformFactory(),
                                                     OT::TriangularFactory()};
  if (values.getMin()[0] > 0) candidates.add(OT::LogNormalFactory());
  OT::Scalar criterion = 0;
  return OT::FittingTest::BestModelBIC(values, candidates, criterion);
}

OT::Distribution joint_distribution(const json& request) {
  OT::Collection<OT::Distribution> margins;
  for (const json& v : request["variables"]) margins.add(cut_off(whole(v), v));
  const json& correlations = request["correlations"];
  if (correlations.empty()) return OT::ComposedDistribution(margins);
  OT::CorrelationMatrix matrix(margins.getSize());
  for (const json& c : correlations)
    matrix(c["i"].get<unsigned>(), c["j"].get<unsigned>()) = c["coefficient"].get<double>();
  return OT::ComposedDistribution(margins, OT::NormalCopula(matrix));
}

OT::Sample draw(const OT::Distribution& joint, const std::string& sampling, unsigned count) {
  if (sampling == "monte-carlo") {  // point by point: more of them only add to fewer
    OT::Sample points(0, joint.getDimension());
    for (unsigned i = 0; i < count; ++i) points.add(joint.getRealization());
    return points;
  }
  // Spread evenly where they are independent, then transformed to what they are.
  const OT::Normal standard(joint.getDimension());
  const auto spread = [&] {
    if (sampling == "latin-hypercube") return OT::LHSExperiment(standard, count).generate();
    const OT::SobolSequence sequence(joint.getDimension());
    OT::LowDiscrepancyExperiment experiment(sequence, standard, count, /*restart=*/true);
    experiment.setRandomize(true);
    return experiment.generate();
  };
  const OT::Sample points = spread();
  return joint.getInverseIsoProbabilisticTransformation()(points);
}

}  // namespace blockweir::probability
