// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_engine
// How many runs a task of a queue gets.
#include "bridge/engine/batch_size.hpp"

#include <gtest/gtest.h>

namespace blockweir::engine::batch_size_test {
namespace {

TEST(BatchSize, IsThatOfTenMinutes) {
  EXPECT_EQ(batch_size(10'000, {.items = 8, .worked_s = 32}), 150U);  // 4 s each
  EXPECT_EQ(batch_size(100, {.items = 8, .worked_s = 8 * 3600}), 1U) << "an hour each";
  EXPECT_EQ(batch_size(10'000, {.items = 8, .worked_s = 0.8}), 6000U) << "a tenth of a second each";
  EXPECT_EQ(batch_size(500, {.items = 8, .worked_s = 0.8}), 500U) << "all of them in one";
}

TEST(BatchSize, IsLargerWhereATaskHasMoreProcessors) {
  EXPECT_EQ(batch_size(10'000, {.items = 8, .worked_s = 32, .processors = 4}), 600U);
}

TEST(BatchSize, MakesNoLongerArraysThanSlurmTakes) {
  EXPECT_EQ(batch_size(10'000, {.items = 8, .worked_s = 8 * 3600}), 10U);
  EXPECT_EQ(batch_size(10'001, {.items = 8, .worked_s = 8 * 3600}), 11U);
}

TEST(BatchSize, OfWhatTakesNoTimeIsAll) {
  EXPECT_EQ(batch_size(300, {.items = 8, .worked_s = 0}), 300U);
}

}  // namespace
}  // namespace blockweir::engine::batch_size_test
