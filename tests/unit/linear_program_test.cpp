// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_limit
// Linear programs that have an optimum, and those that have none.
#include "solid/limit/linear_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace blockweir::linear_program_test {
namespace {

using blockweir::solid::limit::infinite;
using blockweir::solid::limit::LinearProgram;
using blockweir::solid::limit::ProgramStatus;
using testing::HasSubstr;

/// Of the largest sum of `values`, each at most what its row allows.
struct Boxes {
  explicit Boxes(const std::vector<double>& most) {
    for (const double bound : most) {
      const int row = program.add_upper_bound(bound);
      values.push_back(program.add_variable(0, infinite, {{row, 1}}, 1));
    }
  }
  LinearProgram program;
  std::vector<int> values;
};

TEST(LinearProgram, FindsTheOptimumAndItsDualsOfAnyBounds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> bound(0.1, 3);
  for (std::size_t trial = 0; trial < 50; ++trial) {
    std::vector<double> most(1 + trial % 6);
    std::generate(most.begin(), most.end(), [&] { return bound(random); });
    Boxes boxes(most);
    ASSERT_EQ(boxes.program.maximize(), ProgramStatus::optimal);
    for (std::size_t i = 0; i < most.size(); ++i) {
      EXPECT_NEAR(boxes.program.value(boxes.values[i]), most[i], 1e-9);
      EXPECT_NEAR(boxes.program.dual(static_cast<int>(i) + 1), 1, 1e-9);
    }
  }
}

/// Beside any bounded ones, a single variable that nothing bounds is an error that says so, and no number.
TEST(LinearProgram, AnObjectiveThatNothingBoundsIsAnError) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> bound(0.1, 3);
  for (std::size_t trial = 0; trial < 20; ++trial) {
    std::vector<double> most(1 + trial % 6);
    std::generate(most.begin(), most.end(), [&] { return bound(random); });
    Boxes boxes(most);
    const int row = boxes.program.add_upper_bound(bound(random));
    boxes.program.add_variable(0, infinite, {{row, -1}}, 1);
    try {
      boxes.program.maximize();
      FAIL() << "it has no optimum";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(),
                  testing::AllOf(HasSubstr("limit analysis: the simplex method found nothing that bounds "
                                           "the objective, as where blocks jam, on a linear program of "),
                                 HasSubstr("rows and"), HasSubstr("expected an optimum"), HasSubstr("wrong units")));
    }
  }
}

TEST(LinearProgram, EquationsThatContradictEachOtherHaveNoSolution) {
  LinearProgram program;
  const int one = program.add_equation(1);
  const int other = program.add_equation(2);
  program.add_variable(0, infinite, {{one, 1}, {other, 1}}, 1);
  EXPECT_EQ(program.maximize(), ProgramStatus::infeasible);
}

}  // namespace
}  // namespace blockweir::linear_program_test
