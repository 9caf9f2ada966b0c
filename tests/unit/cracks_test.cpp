// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic
// Cracks that joints make: those that a search of all pairs for the straightest continuation finds.
#include "fluid/hydrostatic/crack_elements.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

#include "tests/unit/rubble.hpp"

namespace blockweir::hydrostatic::cracks_test {
namespace {

TEST(Cracks, AreThoseOfASearchOfAllPairs) {
  std::size_t joined = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const scene::Scene scene = rubble(6, 5, seed);
    const std::vector<Crack> cracks = find_cracks(scene);
    const std::vector<Crack> expected = cracks_by_all_pairs(scene, 1e-6);
    ASSERT_EQ(cracks.size(), expected.size()) << seed;
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      EXPECT_EQ(cracks[i].law, expected[i].law);
      EXPECT_EQ(cracks[i].length_m, expected[i].length_m);
      ASSERT_EQ(cracks[i].parts.size(), expected[i].parts.size()) << seed << ' ' << i;
      joined += cracks[i].parts.size() - 1;
      for (std::size_t k = 0; k < cracks[i].parts.size(); ++k) {
        EXPECT_EQ(cracks[i].parts[k].block_a, expected[i].parts[k].block_a);
        EXPECT_EQ(cracks[i].parts[k].block_b, expected[i].parts[k].block_b);
        EXPECT_EQ(cracks[i].parts[k].trace.mouth(), expected[i].parts[k].trace.mouth());
      }
    }
  }
  EXPECT_GT(joined, 200U);
}

TEST(Cracks, AreTheSameFarFromTheOrigin) {
  scene::Scene scene = rubble(6, 5, 1);
  const std::vector<Crack> here = find_cracks(scene);
  for (scene::Block& block : scene.blocks) {
    for (Point& p : block.vertices) p += Point(5e6, -9e6);
  }
  const std::vector<Crack> there = find_cracks(scene);
  ASSERT_EQ(there.size(), here.size());
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(there[i].length_m, here[i].length_m, 1e-6) << i;
}

/// With full uplift under it.
scene::Scene block_on_ground() {
  scene::Scene scene;
  scene.blocks.emplace_back().vertices = {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}};
  scene.blocks.emplace_back().vertices = {{0, 0}, {4, 0}, {4, 5}, {0, 5}};
  scene.default_joint.uplift = scene::Uplift::full;
  return scene;
}

std::vector<std::vector<Point>> outlines_of(const scene::Scene& scene) {
  std::vector<std::vector<Point>> outlines;
  for (const scene::Block& block : scene.blocks) outlines.push_back(block.vertices);
  return outlines;
}

/// A block that had left its joint kept the joint's pressure in flight, and was driven along on dry ground.
TEST(Cracks, HaveNoWaterWhereTheirFacesHaveLeftEachOther) {
  const scene::Scene scene = block_on_ground();
  const std::vector<Crack> cracks = find_cracks(scene);
  ASSERT_EQ(cracks.size(), 1U);
  const joints::Joint joint{.mouth = {3e4, 0}, .end = {0, 0}, .length_m = 4};
  const auto panels = [&](const Point& moved, double turn) {
    std::vector<std::vector<Point>> outlines = outlines_of(scene);
    const Point toe(4, 0);
    for (Point& p : outlines[1]) p = toe + Eigen::Rotation2Dd(turn) * (p - toe) + moved;
    wire::Load load;
    add_crack_elements(cracks.front(), joints::uplift(scene::Uplift::full, {}, joint), 1, outlines, {}, load);
    return load.block.size();
  };
  EXPECT_EQ(panels({0, 0}, 0), 2U);
  EXPECT_EQ(panels({0, 0.39}, 0), 2U) << "less than a tenth of the joint";
  EXPECT_EQ(panels({0, 0.41}, 0), 0U);
  EXPECT_EQ(panels({3, 0}, 0), 2U) << "it slides";
  EXPECT_EQ(panels({4.9, 0}, 0), 2U) << "it has left its joint, and slides on along the same face";
  EXPECT_EQ(panels({9.3, 0}, 0), 2U) << "on the ground's corner";
  EXPECT_EQ(panels({9.5, 0}, 0), 0U);
  EXPECT_EQ(panels({0, 0}, -0.5), 2U) << "it turns about its toe";
  EXPECT_EQ(panels({20, 3}, -0.5), 0U);
}

TEST(Cracks, FullUpliftHasTheHigherPressureOfBothEnds) {
  const scene::Scene scene = block_on_ground();
  const std::vector<Crack> cracks = find_cracks(scene);
  ASSERT_EQ(cracks.size(), 1U);
  for (const auto& [mouth_pa, end_pa] : {std::pair{3e4, 1e4}, std::pair{1e4, 3e4}, std::pair{0.0, 3e4}}) {
    wire::Load load;
    const joints::Joint joint{.mouth = {mouth_pa, 0}, .end = {end_pa, 0}, .length_m = 4};
    add_crack_elements(cracks.front(), joints::uplift(scene::Uplift::full, {}, joint), 1, outlines_of(scene), {}, load);
    ASSERT_EQ(load.block.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(load.pressure_from_pa[i], 3e4);
      EXPECT_EQ(load.pressure_to_pa[i], 3e4);
    }
  }
}

}  // namespace
}  // namespace blockweir::hydrostatic::cracks_test
