// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// Labels of a picture lie within its frame, and none over another.
#include "bridge/picture/label_places.hpp"

#include <gtest/gtest.h>

namespace blockweir::picture::label_places_test {
namespace {

using Point = LabelPlaces::Point;

TEST(LabelPlaces, ALabelStandsWhereItIsWantedIfThatIsFree) {
  LabelPlaces places({{0, 0}, {100, 100}});
  EXPECT_EQ(*places.place({50, 50}, {20, 4}), Point(50, 50));
}

TEST(LabelPlaces, NoneLiesOverAnotherOrOverTheFrame) {
  LabelPlaces places({{0, 0}, {100, 100}});
  const Point size(20, 4);
  places.keep_free({{40, 40}, {60, 60}});
  std::vector<Point> middles;
  for (int i = 0; i < 12; ++i) middles.push_back(*places.place({i < 6 ? 50.0 : 99.0, i < 6 ? 50.0 : 1.0}, size));
  for (std::size_t i = 0; i < middles.size(); ++i) {
    EXPECT_TRUE((middles[i].array() >= (size / 2).array()).all() &&
                (middles[i].array() <= 100 - size.array() / 2).all());
    EXPECT_FALSE(std::abs(middles[i].x() - 50) < 20 && std::abs(middles[i].y() - 50) < 12) << "on what is to stay free";
    for (std::size_t j = 0; j < i; ++j) {
      const Point apart = (middles[i] - middles[j]).cwiseAbs();
      EXPECT_TRUE(apart.x() >= size.x() - 1e-9 || apart.y() >= size.y() - 1e-9) << i << " and " << j;
    }
  }
}

TEST(LabelPlaces, WhereLinesAreEverywhereLabelsStandOverThemButNotOverEachOther) {
  LabelPlaces places({{0, 0}, {100, 30}});
  places.keep_free({{0, 0}, {100, 30}});
  const Point size(40, 8);
  std::vector<Point> middles;
  while (const auto middle = places.place({50, 15}, size)) middles.push_back(*middle);
  EXPECT_GE(middles.size(), 2U);
  for (std::size_t i = 0; i < middles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Point apart = (middles[i] - middles[j]).cwiseAbs();
      EXPECT_TRUE(apart.x() >= size.x() - 1e-9 || apart.y() >= size.y() - 1e-9) << i << " and " << j;
    }
  }
  EXPECT_FALSE(places.place({50, 15}, {101, 1}));
}

}  // namespace
}  // namespace blockweir::picture::label_places_test
