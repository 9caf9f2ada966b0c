// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_results
// Watches in scopes of which samples are timed, against a watch about and one within them.
#include "bridge/results/stopwatch.hpp"

#include <gtest/gtest.h>

namespace blockweir::stopwatch_test {
namespace {

void work(double& sum_s, double& within_s) {
  const Stopwatch watch(sum_s);
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() == start) {
  }
  within_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Stopwatch, CountsASampleForAllThatItStandsFor) {
  double about_s = 0;
  double sampled_s = 0;
  double within_s = 0;
  {
    const Stopwatch about(about_s);
    const Stopwatch::Sample sample(16);
    work(sampled_s, within_s);
  }
  EXPECT_LE(sampled_s, 16 * about_s);
  EXPECT_GE(sampled_s, 16 * within_s);
}

TEST(Stopwatch, LooksAtNoClockInScopesThatAreLeftOut) {
  double left_out_s = 0;
  double inner_s = 0;
  double after_s = 0;
  double within_s = 0;
  {
    const Stopwatch::Sample none(0);
    work(left_out_s, within_s);
    const Stopwatch::Sample inner(2);
    work(inner_s, within_s);
  }
  work(after_s, within_s);
  EXPECT_EQ(left_out_s, 0);
  EXPECT_GT(inner_s, 0);
  EXPECT_GT(after_s, 0);
}

}  // namespace
}  // namespace blockweir::stopwatch_test
