// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_geometry
#include "bridge/geometry/box_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace blockweir::geometry::box_index_test {
namespace {

class ABoxIndex : public testing::TestWithParam<unsigned> {
 protected:
  void SetUp() override {
    std::uniform_real_distribution<double> place(0, 10), size(0, 2);
    for (std::size_t i = 0; i < 200; ++i) {
      const Point low(place(random_), place(random_));
      boxes_.emplace_back(Bounds{low, low + Point(size(random_), size(random_))}, 2 * i);
    }
  }
  [[nodiscard]] std::vector<std::size_t> meeting_by_search(const Bounds& b) const {
    std::vector<std::size_t> found;
    for (const auto& [box, number] : boxes_) {
      if ((box.low.array() <= b.high.array()).all() && (box.high.array() >= b.low.array()).all())
        found.push_back(number);
    }
    return found;
  }

  std::mt19937 random_{GetParam()};
  std::vector<BoxIndex::Entry> boxes_;
};
INSTANTIATE_TEST_SUITE_P(Seeds, ABoxIndex, testing::Range(0U, 4U));

TEST_P(ABoxIndex, FindsWhatASearchOfAllFinds) {
  const BoxIndex index(boxes_);
  for (const auto& [box, number] : boxes_) {
    EXPECT_THAT(index.meeting(box), testing::UnorderedElementsAreArray(meeting_by_search(box)));
    EXPECT_TRUE(index.any_meets(box));
  }
  EXPECT_FALSE(index.any_meets({{20, 20}, {21, 21}}));
}

TEST_P(ABoxIndex, ForgetsABox) {
  BoxIndex index(boxes_);
  const BoxIndex::Entry gone = boxes_[7];
  boxes_.erase(boxes_.begin() + 7);
  index.forget(gone);
  EXPECT_THAT(index.meeting(gone.first), testing::UnorderedElementsAreArray(meeting_by_search(gone.first)));
}

TEST_P(ABoxIndex, OfPointsFindsTheNearest) {
  std::vector<Point> points;
  for (const auto& [box, number] : boxes_) points.push_back(box.low);
  const BoxIndex index(points);
  for (const BoxIndex::Entry& entry : boxes_) {
    const Point& from = entry.first.high;
    const auto closer = [&](const Point& a, const Point& b) { return (a - from).norm() < (b - from).norm(); };
    const auto nearest = std::min_element(points.begin(), points.end(), closer) - points.begin();
    EXPECT_THAT(index.nearest(from, 1), testing::ElementsAre(nearest));
  }
  EXPECT_EQ(index.nearest({0, 0}, 500).size(), points.size());
}

TEST(AnEmptyBoxIndex, FindsNothing) {
  const BoxIndex index((std::vector<Point>()));
  EXPECT_TRUE(index.meeting({{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(index.nearest({0, 0}, 1).empty());
}

}  // namespace
}  // namespace blockweir::geometry::box_index_test
