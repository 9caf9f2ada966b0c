// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read bridge_statics
// Blocks listed in another order: the project's scenes keep what refers to them.
#include "bridge/scene/reordered.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/statics/loads.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_reordered_test {
using namespace blockweir::scene;

namespace {

template <class Test>
void for_each_case(Test test) {
  std::mt19937 random(1);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(BLOCKWEIR_SOURCE) + "/cases")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    const Scene scene = read(entry.path()).scene;
    std::vector<int> order(scene.blocks.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    test(scene, order);
  }
}

TEST(SceneReordered, PutsTheBlocksInThatOrder) {
  for_each_case([](const Scene& scene, const std::vector<int>& order) {
    const Scene other = reordered(scene, order);
    for (std::size_t b = 0; b < order.size(); ++b) EXPECT_EQ(other.blocks[b].name, scene.blocks[at(order[b])].name);
  });
}

TEST(SceneReordered, AndBackIsTheSceneItself) {
  for_each_case([](const Scene& scene, const std::vector<int>& order) {
    std::vector<int> back(order.size());
    for (std::size_t b = 0; b < order.size(); ++b) back[at(order[b])] = static_cast<int>(b);
    EXPECT_TRUE(reordered(reordered(scene, order), back) == scene);
  });
}

TEST(SceneReordered, JointsAndBoltsAreOfTheSameBlocks) {
  for_each_case([](const Scene& scene, const std::vector<int>& order) {
    const Scene other = reordered(scene, order);
    const auto name = [](const Scene& of, int block) { return block < 0 ? "ground" : of.blocks[at(block)].name; };
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      for (const std::size_t side : {0, 1})
        EXPECT_EQ(name(other, other.joints[j].between[side]), name(scene, scene.joints[j].between[side]));
    }
    for (std::size_t j = 0; j < scene.bolts.size(); ++j) {
      for (const std::size_t side : {0, 1})
        EXPECT_EQ(name(other, other.bolts[j].blocks[side]), name(scene, scene.bolts[j].blocks[side]));
    }
  });
}

TEST(SceneReordered, EachBlockBearsTheSameLoads) {
  for_each_case([](const Scene& scene, const std::vector<int>& order) {
    const Scene other = reordered(scene, order);
    const auto before = statics::stated_loads_of(scene, scene.analysis.duration_s);
    const auto after = statics::stated_loads_of(other, scene.analysis.duration_s);
    for (std::size_t b = 0; b < order.size(); ++b) EXPECT_EQ(after[b], before[at(order[b])]);
  });
}

TEST(SceneReordered, FromLeftToRightIsByTheMiddles) {
  const Scene scene = read(std::string(BLOCKWEIR_SOURCE) + "/cases/brick-dam").scene;
  for (const bool upwards : {true, false}) {
    std::pair<double, double> before(-std::numeric_limits<double>::infinity(), 0);
    for (const int b : from_left_to_right(scene, upwards)) {
      const auto box = geometry::bounds_of(scene.blocks[at(b)].vertices);
      const Eigen::Vector2d twice_middle = box.low + box.high;
      const std::pair place(twice_middle.x(), upwards ? twice_middle.y() : -twice_middle.y());
      EXPECT_LE(before, place);
      before = place;
    }
  }
}

}  // namespace
}  // namespace blockweir::scene_reordered_test
