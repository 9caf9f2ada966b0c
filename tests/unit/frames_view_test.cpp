// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_picture
// What of a run's moments a picture shows.
#include <gtest/gtest.h>

#include "bridge/picture/frames.hpp"

namespace blockweir::picture::frames_view_test {
namespace {

using nlohmann::json;

/// Unit squares with their lower left corner at each x, on the ground's level.
json frame_with_squares_at(const std::vector<double>& places) {
  json frame = json::parse(R"({"upstream_level_m": null, "downstream_level_m": null, "blocks": [
      {"fixed": true, "outline": [[-100, -1], [100, -1], [100, 0], [-100, 0]]}]})");
  for (const double x : places)
    frame["blocks"].push_back({{"fixed", false}, {"outline", {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}}});
  return frame;
}

constexpr double still_water = 1e300;

TEST(FramesView, ABlockThatSlidesTwiceItsLengthStaysInThePicture) {
  const View view = view_of({frame_with_squares_at({0}), frame_with_squares_at({1.9})}, still_water);
  EXPECT_GT(view.right, 2.9);
  EXPECT_LT(view.right, 5);
}

TEST(FramesView, ABlockThatIsThrownFarLeavesThePicture) {
  const View view = view_of({frame_with_squares_at({0}), frame_with_squares_at({50})}, still_water);
  EXPECT_LT(view.right, 5);
  EXPECT_EQ(blocks_beyond(frame_with_squares_at({0}), view), 0U);
  EXPECT_EQ(blocks_beyond(frame_with_squares_at({50}), view), 1U);
}

TEST(FramesView, OneBlockOfTwentyDoesNotMakeTheOthersSmall) {
  std::vector<double> places;
  for (int k = 0; k < 20; ++k) places.push_back(k);
  const json before = frame_with_squares_at(places);
  places.back() = 55;
  EXPECT_LT(view_of({before, frame_with_squares_at(places)}, still_water).right, 30);
}

TEST(FramesView, AFixedWallIsShownWhereItAloneStandsInWater) {
  json frame = json::parse(R"({"upstream_level_m": 10, "downstream_level_m": null, "blocks": [
      {"fixed": true, "outline": [[0, 0], [4, 0], [4, 10], [0, 10]]},
      {"fixed": false, "outline": [[1, 10], [3, 10], [3, 11], [1, 11]]}]})");
  EXPECT_LT(view_of({frame}, still_water).bottom, 0);
  frame["upstream_level_m"] = 10.5;
  EXPECT_GT(view_of({frame}, still_water).bottom, 9);
}

}  // namespace
}  // namespace blockweir::picture::frames_view_test
