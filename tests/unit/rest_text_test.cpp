// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_output
// What a static analysis came to: no text says that nothing is unbalanced where there is no equilibrium.
#include "solid/output/rest_text.hpp"

#include <gtest/gtest.h>

namespace blockweir::solid::output::rest_text_test {
namespace {

std::string text(bool found, int steps, double unbalanced, long all_steps = 7) {
  scene::Analysis analysis;
  analysis.residual_tolerance = 1e-9;
  analysis.failure_displacement_m = 5e-3;
  Rest rest;
  rest.found = found;
  rest.steps = steps;
  rest.unbalanced = unbalanced;
  return rest_text(rest, all_steps, analysis, 0.0123);
}

TEST(RestText, SaysWhyThereIsNoEquilibrium) {
  EXPECT_EQ(text(true, 3, 1e-12), "at rest after 7 steps, 1e-12 of the weight unbalanced");
  EXPECT_EQ(text(true, 1, 1e-12, 1), "at rest after 1 step, 1e-12 of the weight unbalanced");
  EXPECT_EQ(text(false, 3, 0.25),
            "no equilibrium: 0.25 of the weight unbalanced after 7 steps, largest displacement 0.0123 m");
  EXPECT_EQ(text(false, 3, 0),
            "no equilibrium: after 7 steps forces balance, but only where joints have slipped by more than "
            "failure_displacement_m = 0.005 m; largest displacement 0.0123 m");
  EXPECT_EQ(text(false, 0, 0), "no equilibrium: no step towards it could be solved; largest displacement 0.0123 m");
}

}  // namespace
}  // namespace blockweir::solid::output::rest_text_test
