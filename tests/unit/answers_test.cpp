// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_expect
// The names that a scene may expect are those that the solid knows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bridge/scene/quantity_table.hpp"
#include "solid/expect/formulas.hpp"
#include "solid/expect/outcome_labels.hpp"

namespace blockweir::solid::expect::answers_test {
namespace {

std::vector<std::string> both(std::vector<std::string> names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

TEST(Answers, QuantitiesOfASceneAreTheSolids) {
  EXPECT_THAT(scene::quantity_names(),
              testing::UnorderedElementsAreArray(both(quantity_names(), label_quantity_names())));
}

TEST(Answers, FormulasOfASceneAreTheSolids) {
  EXPECT_THAT(scene::formula_names(), testing::UnorderedElementsAreArray(both(formula_names(), label_formula_names())));
}

}  // namespace
}  // namespace blockweir::solid::expect::answers_test
