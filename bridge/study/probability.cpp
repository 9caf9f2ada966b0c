// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/study/probability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <stdexcept>

namespace blockweir::study {
namespace {

using nlohmann::json;

json distribution_json(const scene::Distribution& d) {
  const auto number = [](const std::optional<double>& value) { return value ? json(*value) : json(); };
  return {{"distribution", d.kind}, {"mean", d.mean},     {"deviation", d.deviation},
          {"from", d.from},         {"peak", d.peak},     {"to", d.to},
          {"table", d.table},       {"values", d.values}, {"least", number(d.least)},
          {"most", number(d.most)}};
}

std::vector<scene::Distribution> distributions_of(const scene::Randomness& randomness) {
  std::vector<scene::Distribution> all;
  for (const auto& variable : randomness.variables) all.push_back(variable.distribution);
  return all;
}

json correlations_json(const scene::Randomness& randomness) {
  json all = json::array();
  const auto index = [&](const std::string& name) {
    return std::find_if(randomness.variables.begin(), randomness.variables.end(),
                        [&](const auto& v) { return v.name == name; }) -
           randomness.variables.begin();
  };
  for (const auto& c : randomness.correlations) {
    all.push_back({{"i", index(c.between[0])}, {"j", index(c.between[1])}, {"coefficient", c.coefficient}});
  }
  return all;
}

std::unique_ptr<process::LineProgram> started() {
  return std::make_unique<process::LineProgram>(std::vector<std::string>{"blockweir-probability"});
}

}  // namespace

Probability::Probability(const std::vector<scene::Distribution>& distributions, int seed)
    : common_({{"seed", seed}, {"variables", json::array()}, {"correlations", json::array()}}), program_(started()) {
  for (const auto& distribution : distributions) common_["variables"].push_back(distribution_json(distribution));
}

Probability::Probability(const scene::Randomness& randomness)
    : Probability(distributions_of(randomness), randomness.reliability.seed) {
  common_["correlations"] = correlations_json(randomness);
}

json Probability::ask(json request, const Evaluate& evaluate) {
  for (const auto& [key, value] : common_.items()) {
    if (!request.contains(key)) request[key] = value;
  }
  json reply = program_->ask(request);
  while (reply.contains("evaluate")) {
    std::vector<double> values;
    try {
      values = evaluate(reply["evaluate"].get<std::vector<RandomPoint>>());
    } catch (...) {  // it waits for values that do not come
      program_ = started();
      throw;
    }
    reply = program_->ask({{"values", values}});
  }
  if (reply.contains("answer")) return reply["answer"];
  if (reply.contains("at")) throw Unanswered(reply["trouble"], reply["at"]);
  throw std::runtime_error(reply.value("trouble", "no answer"));
}

Settings settings_of_one(const scene::Randomness& randomness, std::size_t v, const RandomPoint& point) {
  const scene::RandomVariable& variable = randomness.variables.at(v);
  Settings settings = variable.set;
  if (!variable.key.empty()) settings.push_back(setting(variable.key, point[v]));
  for (std::string& text : settings) {  // a setting may hold several of them
    for (std::size_t i = 0; i < point.size(); ++i) {
      boost::replace_all(text, "{" + randomness.variables[i].name + "}", fmt::format("{}", point[i]));
    }
  }
  return settings;
}

Settings settings_of(const scene::Randomness& randomness, const RandomPoint& point) {
  Settings settings;
  for (std::size_t v = 0; v < point.size(); ++v) {
    for (std::string& text : settings_of_one(randomness, v, point)) settings.push_back(std::move(text));
  }
  return settings;
}

}  // namespace blockweir::study
