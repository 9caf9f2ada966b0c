// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic
// Cracks of thousands of joints are found in less time than those of hundreds by a search of all pairs.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/unit/rubble.hpp"

namespace blockweir::hydrostatic::cracks_at_scale_test {
namespace {

/// Those of 3,000 blocks take less than those of a tenth as many take by all pairs.
TEST(CracksAtScale, OfThousandsOfJointsAreFoundAtOnce) {
  const auto seconds = [](const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_FALSE(work().empty());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const scene::Scene many = rubble(60, 50, 1);
  const scene::Scene few = rubble(20, 15, 1);
  EXPECT_LT(seconds([&] { return find_cracks(many); }), seconds([&] { return cracks_by_all_pairs(few, 1e-6); }));
}

}  // namespace
}  // namespace blockweir::hydrostatic::cracks_at_scale_test
