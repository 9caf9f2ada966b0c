// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_reliability
// Quantiles of what a [[random]] may be, by their closed forms.
#include "bridge/reliability/distribution_quantile.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blockweir::study::distribution_quantile_test {
namespace {

using scene::Distribution;

TEST(DistributionQuantile, IsThatOfTheClosedForm) {
  constexpr double rare = 1e-4;
  constexpr double rare_normal = -3.719016485;
  EXPECT_NEAR(quantile_of({.kind = "normal", .mean = 30, .deviation = 2}, rare), 30 + 2 * rare_normal, 1e-7);
  const double s =
      std::sqrt(std::log(1 + 0.25));  // deviation of the logarithm, where that of the value is half its mean
  EXPECT_NEAR(quantile_of({.kind = "lognormal", .mean = 8, .deviation = 4}, rare),
              8 * std::exp(-s * s / 2 + s * rare_normal), 1e-7);
  EXPECT_NEAR(quantile_of({.kind = "uniform", .from = 2, .to = 4}, 0.25), 2.5, 1e-12);
  EXPECT_NEAR(quantile_of({.kind = "triangular", .from = 1, .peak = 2, .to = 6}, 0.05), 1.5, 1e-12);
  EXPECT_NEAR(quantile_of({.kind = "triangular", .from = 1, .peak = 1, .to = 6}, 0.5), 6 - 5 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(quantile_of({.kind = "table", .table = {{1, 0}, {2, 0.5}, {2.5, 0.5}, {4, 1}}}, 0.75), 3.25, 1e-12);
  EXPECT_EQ(quantile_of({.kind = "fitted", .values = {5, 3, 4, 1, 2}}, rare), 1);
}

TEST(DistributionQuantile, OfOneThatIsCutOffLiesWithinTheCuts) {
  const Distribution cut{.kind = "normal", .mean = 1, .deviation = 1, .least = 1};
  EXPECT_NEAR(quantile_of(cut, 0.5), 1.6744897502, 1e-9);
  EXPECT_EQ(quantile_of({.kind = "normal", .mean = 0, .deviation = 1, .least = 20}, 0.5), 20);
  EXPECT_GE(quantile_of({.kind = "lognormal", .mean = 1, .deviation = 1, .least = -1}, 1e-4), 0);
  EXPECT_LE(quantile_of({.kind = "triangular", .from = 1, .peak = 2, .to = 6, .most = 7}, 0.9999), 6);
}

}  // namespace
}  // namespace blockweir::study::distribution_quantile_test
