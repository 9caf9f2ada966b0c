// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_reliability
// How the answer of `reliability` is told.
#include "bridge/reliability/reliability_output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace blockweir::study {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

json answer_with(double first, double total) {
  return {{"by", "limit"},
          {"sampling", "monte-carlo"},
          {"level_m", 5},
          {"variables", {"phi"}},
          {"samples",
           {{"count", 10},
            {"probability", 0.1},
            {"interval", {0, 0.3}},
            {"index", 1.3},
            {"that_stand", 0},
            {"that_never_stand", 0},
            {"without_answer", 0},
            {"made", 0}}},
          {"sobol", {{"first", {first}}, {"total", {total}}, {"evaluations", 400}}}};
}

TEST(ReliabilityTold, ASobolShareInAllBelowThatAloneIsSaidToBeNoise) {
  EXPECT_THAT(reliability_text(answer_with(0.998, 0.945)),
              HasSubstr("where it is, by up to 0.053, that is the noise of 400 samples;"));
  EXPECT_THAT(reliability_text(answer_with(0.945, 0.998)), Not(HasSubstr("noise")));
}

}  // namespace
}  // namespace blockweir::study
