// SPDX-License-Identifier: GPL-3.0-or-later
// blockweir-probability: OpenTURNS for blockweir reliability, in a separate program, since OpenTURNS takes a tenth of a
// second to load. It reads requests in JSON, one each line, and answers on standard output. During a request it may
// send {"evaluate": points} and expects {"values": ...}, null where there is none. If it needs one that there is not,
// its "trouble" has the point as "at".
#include <openturns/Log.hxx>
#include <openturns/RandomGenerator.hxx>
#include <openturns/ResourceMap.hxx>

#include <cmath>
#include <iostream>

#include "bridge/probability/distributions.hpp"
#include "bridge/probability/methods.hpp"

namespace {

using namespace blockweir;
using nlohmann::json;

json rows_of(const OT::Sample& sample) {
  json rows = json::array();
  for (OT::UnsignedInteger i = 0; i < sample.getSize(); ++i) {
    const OT::Point row = sample[i];
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return rows;
}

void say(const json& line) {
  std::cout << line.dump() << std::endl;
}

json hear() {
  std::string line;
  if (!std::getline(std::cin, line)) std::exit(0);  // whoever asked has gone
  return json::parse(line);
}

OT::Sample evaluate(const OT::Sample& points) {
  say({{"evaluate", rows_of(points)}});
  const json values = hear()["values"];
  OT::Sample all(values.size(), 1);
  for (std::size_t i = 0; i < values.size(); ++i)
    all(i, 0) = values[i].is_null() ? std::nan("") : values[i].get<double>();
  return all;
}

json fit(const json& request) {
  OT::Sample values(0, 1);
  for (const json& value : request["values"]) values.add(OT::Point(1, value.get<double>()));
  const OT::Distribution best = probability::fitted(values);
  const OT::Point parameters = best.getParameter();
  const OT::Description names = best.getParameterDescription();
  return {{"distribution", best.getImplementation()->getClassName()},
          {"mean", best.getMean()[0]},
          {"deviation", best.getStandardDeviation()[0]},
          {"parameter_names", std::vector<std::string>(names.begin(), names.end())},
          {"parameters", std::vector<double>(parameters.begin(), parameters.end())}};
}

json draws(const OT::Distribution& joint, const json& request) {
  json points = json::array();
  for (int group = 0; group < request["groups"].get<int>(); ++group) {
    for (const json& row : rows_of(probability::draw(joint, request["sampling"], request["count"].get<unsigned>()))) {
      points.push_back(row);
    }
  }
  const OT::Point means = joint.getMean();
  return {{"points", points}, {"means", std::vector<double>(means.begin(), means.end())}};
}

json answer_to(const json& request) {
  OT::RandomGenerator::SetSeed(request["seed"].get<unsigned>());
  const std::string what = request["do"];
  if (what == "fit") return fit(request);
  const OT::Distribution joint = probability::joint_distribution(request);
  if (what == "draw") return draws(joint, request);
  const unsigned samples = request["samples"];
  if (what == "sobol") return probability::sobol(joint, evaluate, samples);
  const double threshold = request["threshold"];
  if (what == "importance") return probability::importance_sampling(joint, evaluate, threshold, samples);
  if (what == "subset") return probability::subset_sampling(joint, evaluate, threshold, samples);
  return probability::form(joint, evaluate, threshold, what == "sorm");
}

}  // namespace

int main() {
  OT::Log::Show(OT::Log::NONE);
  for (std::string line; std::getline(std::cin, line);) {
    try {
      say({{"answer", answer_to(json::parse(line))}});
    } catch (const probability::Unanswered& error) {
      say({{"trouble", error.what()}, {"at", std::vector<double>(error.at.begin(), error.at.end())}});
    } catch (const std::exception& error) {
      say({{"trouble", error.what()}});
    }
  }
  return 0;
}
