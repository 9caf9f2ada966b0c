// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic
// Cracks that joints make: those that a search of all pairs for the straightest continuation finds, found in less time.
#include "fluid/hydrostatic/crack_elements.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>

#include "bridge/scene/at.hpp"

namespace blockweir::hydrostatic {
namespace {

using scene::Crack;
using scene::CrackPart;
using scene::find_cracks;
using scene::Point;

/// Columns of blocks between lines that go up and down, each column with heights of its own or of its neighbour.
scene::Scene rubble(int columns, int rows, unsigned seed) {
  std::mt19937 random(seed);
  const auto any = [&](int most) { return static_cast<double>(random() % static_cast<unsigned>(most + 1)); };
  scene::Scene scene;
  scene.default_joint.uplift = scene::Uplift::triangular;
  std::vector<double> fall(at(columns + 1));
  for (double& f : fall) f = 0.2 * any(3);
  std::vector<double> heights(at(rows + 1));
  for (int c = 0; c < columns; ++c) {
    double height = 0;
    if (c == 0 || any(2) > 0) {
      for (double& h : heights) h = height, height += 1 + any(1);
    }
    for (int r = 0; r < rows; ++r) {
      const auto corner = [&](int x, int y) { return Point(c + x, heights[at(r + y)] - fall[at(c + x)]); };
      scene.blocks.emplace_back().vertices = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    }
  }
  for (int j = 0; j < columns; ++j) {  // some are named, with laws of their own
    scene::Joint& joint = scene.joints.emplace_back();
    joint.between = {j * rows, j * rows + 1};
    joint.law.uplift = j % 3 == 0 ? scene::Uplift::full : scene::Uplift::triangular;
  }
  return scene;
}

double straightness(const Crack& before, const Crack& after, double touching_m) {
  const auto along = [](const scene::TracePiece& piece) { return Point((piece.to_m - piece.from_m).normalized()); };
  const scene::JointTrace& a = before.parts.back().trace;
  const scene::JointTrace& b = after.parts.front().trace;
  if (before.law != after.law || (a.end() - b.mouth()).norm() > touching_m) return -1;
  return along(a.pieces.back()).dot(along(b.pieces.front()));
}

/// All pairs of blocks, then all pairs of cracks for each that is joined.
std::vector<Crack> cracks_by_all_pairs(const scene::Scene& scene, double touching_m) {
  std::vector<Crack> cracks;
  const auto add = [&](int a, int b, scene::Uplift law) {
    scene::JointTrace trace = scene::trace_joint(scene.blocks[at(a)], scene.blocks[at(b)], touching_m);
    const double length = trace.length_m;
    if (!trace.pieces.empty()) cracks.push_back({law, {}, {{a, b, trace}}, length});
  };
  for (const scene::Joint& joint : scene.joints) add(joint.between[0], joint.between[1], joint.law.uplift);
  for (int a = 0; a < static_cast<int>(scene.blocks.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(scene.blocks.size()); ++b) {
      const bool named = std::any_of(scene.joints.begin(), scene.joints.end(), [&](const scene::Joint& joint) {
        return joint.between[0] == a && joint.between[1] == b;
      });
      if (!named) add(a, b, scene.default_joint.uplift);
    }
  }
  for (;;) {
    double best = std::sqrt(0.5);
    std::size_t before = 0;
    std::size_t after = 0;
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      for (std::size_t j = 0; j < cracks.size(); ++j) {
        const double found = i == j ? -1 : straightness(cracks[i], cracks[j], touching_m);
        if (found > best) best = found, before = i, after = j;
      }
    }
    if (before == after) return cracks;
    cracks[before].length_m += cracks[after].length_m;
    for (const CrackPart& part : cracks[after].parts) cracks[before].parts.push_back(part);
    cracks.erase(cracks.begin() + static_cast<std::ptrdiff_t>(after));
  }
}

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

/// Those of 3,000 blocks take less than those of a tenth as many take by all pairs.
TEST(Cracks, OfThousandsOfJointsAreFoundAtOnce) {
  const auto seconds = [](const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_FALSE(work().empty());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const scene::Scene many = rubble(60, 50, 1);
  const scene::Scene few = rubble(20, 15, 1);
  EXPECT_LT(seconds([&] { return find_cracks(many); }), seconds([&] { return cracks_by_all_pairs(few, 1e-6); }));
}

TEST(Cracks, FullUpliftHasTheHigherPressureOfBothEnds) {
  scene::Scene scene;
  scene.blocks.emplace_back().vertices = {{-9, -1}, {9, -1}, {9, 0}, {-9, 0}};
  scene.blocks.emplace_back().vertices = {{0, 0}, {4, 0}, {4, 5}, {0, 5}};
  scene.default_joint.uplift = scene::Uplift::full;
  const std::vector<Crack> cracks = find_cracks(scene);
  ASSERT_EQ(cracks.size(), 1U);
  for (const auto& [mouth_pa, end_pa] : {std::pair{3e4, 1e4}, std::pair{1e4, 3e4}, std::pair{0.0, 3e4}}) {
    wire::Load load;
    const joints::Joint joint{.mouth = {mouth_pa, 0}, .end = {end_pa, 0}, .length_m = 4};
    add_crack_elements(cracks.front(), joints::uplift(scene::Uplift::full, {}, joint), 1, {}, load);
    ASSERT_EQ(load.block.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(load.pressure_from_pa[i], 3e4);
      EXPECT_EQ(load.pressure_to_pa[i], 3e4);
    }
  }
}

}  // namespace
}  // namespace blockweir::hydrostatic
