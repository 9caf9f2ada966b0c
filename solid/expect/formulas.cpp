// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/expect/formulas.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "solid/expect/formula_tables.hpp"
#include "solid/expect/point_figures.hpp"

namespace blockweir::solid::expect {
namespace {

const Formulas& formulas() {
  static const Formulas all = [] {
    Formulas sum;
    for (const Formulas& some : {block_formulas(), dam_formulas(), dynamics_formulas(), masonry_formulas(),
                                 motion_formulas(), slope_formulas()})
      sum.insert(some.begin(), some.end());
    return sum;
  }();
  return all;
}

}  // namespace

std::vector<std::string> formula_names() {
  std::vector<std::string> names;
  for (const auto& [name, function] : formulas()) names.push_back(name);
  for (const auto& [name, function] : point_formulas()) names.push_back(name);
  return names;
}

double formula(const Scene& scene, const scene::Expectation& expectation) {
  const auto at_point = point_formulas().find(expectation.formula);
  if (at_point != point_formulas().end() && expectation.at_m) {
    return at_point->second(scene, block_named(scene, expectation.of), *expectation.at_m);
  }
  const auto found = formulas().find(expectation.formula);
  if (found == formulas().end()) {
    throw std::runtime_error(fmt::format("[[expect]] names no formula: \"{}\"", expectation.formula));
  }
  return found->second(scene, expectation.of);
}

}  // namespace blockweir::solid::expect
