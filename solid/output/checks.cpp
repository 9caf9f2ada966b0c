// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "solid/expect/formulas.hpp"
#include "solid/expect/outcome_labels.hpp"

namespace blockweir::solid::output {
namespace {

using nlohmann::json;

json number_check(const expect::Outcome& outcome, const scene::Expectation& e) {
  double got = std::numeric_limits<double>::quiet_NaN();
  std::string why_none;
  try {
    got = expect::quantity(outcome, e);
  } catch (const expect::NoFigure& none) {
    why_none = none.what();
  }
  if (!e.word.empty())
    throw std::runtime_error(
        fmt::format("{} is a number; found word = \"{}\"; state value = a number in its place", e.quantity, e.word));
  const double expected = e.value ? *e.value : expect::formula(outcome.solid.scene(), e);
  const double error = expected == 0 ? std::abs(got) : std::abs(got / expected - 1);
  json check = {{"expected", expected},
                {"got", got},
                {"relative_error", error},
                {"tolerance", e.tolerance},
                {"passed", error <= e.tolerance}};
  if (!why_none.empty()) check["why_none"] = why_none;
  return check;
}

/// Right or wrong: a word has no error between.
json word_check(const expect::Outcome& outcome, const scene::Expectation& e) {
  const std::string got = expect::label(outcome, e);
  if (e.value)
    throw std::runtime_error(
        fmt::format("{} is a word; found value = {}; state word = \"...\" in its place", e.quantity, *e.value));
  const std::string expected = e.word.empty() ? expect::word_formula(outcome.solid.scene(), e) : e.word;
  return {{"expected", expected},
          {"got", got},
          {"relative_error", got == expected ? 0.0 : 1.0},
          {"tolerance", 0.0},
          {"passed", got == expected}};
}

/// For an expectation that this scene cannot answer; the rest of the run is still checked.
json no_check(const char* trouble) {
  return {{"expected", nullptr},  {"got", nullptr},  {"relative_error", nullptr},
          {"tolerance", nullptr}, {"passed", false}, {"trouble", trouble}};
}

}  // namespace

json checks(const expect::Outcome& outcome) {
  json list = json::array();
  for (const scene::Expectation& e : outcome.solid.scene().expectations) {
    json check;
    try {
      check = expect::is_label(e.quantity) ? word_check(outcome, e) : number_check(outcome, e);
    } catch (const std::runtime_error& error) {
      check = no_check(error.what());
    }
    check["name"] = e.of.empty() ? e.quantity : e.quantity + " of " + e.of;
    check["formula"] = e.formula;
    check["source"] = e.source;
    list.push_back(std::move(check));
  }
  return list;
}

}  // namespace blockweir::solid::output
