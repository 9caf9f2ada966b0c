// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic
// Which faces water reaches: gaps, slips, ledges, and wherever the model stands.
#include "fluid/hydrostatic/wet_faces.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "bridge/scene/at.hpp"

namespace blockweir::hydrostatic::wet_faces_test {
namespace {

TEST(WetFaces, NarrowGapsCarryNoWaterAndWideOnesDo) {
  const auto wet_length = [](double gap) {
    const std::vector<std::vector<Point>> outlines = {{{0, 0}, {4, 0}, {4, 5}, {0, 5}},
                                                      {{0, 5 + gap}, {4, 5 + gap}, {4, 12}, {0, 12}}};
    double length = 0;
    for (const WetInterval& w : wet_faces({outlines}, Pool::upstream, 10).intervals) {
      const auto& o = outlines[at(w.block)];
      const auto e = at(w.edge);
      length += (w.s_to - w.s_from) * (o[(e + 1) % 4] - o[e]).norm();
    }
    return length;
  };
  EXPECT_NEAR(wet_length(0), 10, 1e-9);
  EXPECT_NEAR(wet_length(0.01), 10, 0.02);
  EXPECT_GT(wet_length(0.2), 17);  // both faces of the gap, 4 m each
}

/// Behind two blocks with a gap between them stands a third, 2 m away.
TEST(WetFaces, WaterReachesWhatStandsBehindTheCrestThroughAWideGapOnly) {
  for (const Pool pool : {Pool::upstream, Pool::downstream}) {
    const auto wet_behind = [&](double gap) {
      std::vector<std::vector<Point>> outlines = {{{0, 0}, {4, 0}, {4, 5}, {0, 5}},
                                                  {{0, 5 + gap}, {4, 5 + gap}, {4, 12}, {0, 12}},
                                                  {{6, 0}, {8, 0}, {8, 11}, {6, 11}}};
      for (auto& outline : outlines) {
        if (pool == Pool::upstream) break;
        for (Point& p : outline) p.x() *= -1;
        std::reverse(outline.begin(), outline.end());
      }
      double length = 0;
      for (const WetInterval& w : wet_faces({outlines}, pool, 10).intervals) {
        const auto& o = outlines[at(w.block)];
        const auto e = at(w.edge);
        if (w.block == 2) length += (w.s_to - w.s_from) * (o[(e + 1) % 4] - o[e]).norm();
      }
      return length;
    };
    EXPECT_EQ(wet_behind(0.01), 0);
    EXPECT_NEAR(wet_behind(0.2), 10, 1e-6);  // its face
  }
}

/// The same, and without the third block: water stays before the crest, gets behind it, finds its way out.
TEST(WetFaces, AreTheSameToTheBitWhereverWaterWasExpected) {
  for (const bool way_out : {false, true}) {
    for (const double gap : {0.01, 0.2}) {
      std::vector<std::vector<Point>> outlines = {{{0, 0}, {4, 0}, {4.1, 5}, {0, 5}},
                                                  {{0, 5 + gap}, {4.2, 5 + gap}, {4, 12}, {0.1, 12}}};
      if (!way_out) outlines.push_back({{6, 0}, {8, 0}, {8, 11}, {6, 11}});
      const WetFaces a = wet_faces({outlines}, Pool::upstream, 10, false);
      const WetFaces b = wet_faces({outlines}, Pool::upstream, 10, true);
      EXPECT_EQ(a.behind, gap > 0.1);
      EXPECT_EQ(a.breached, gap > 0.1 && way_out);
      EXPECT_EQ(b.behind, a.behind);
      EXPECT_EQ(b.breached, a.breached);
      EXPECT_EQ(b.region, a.region);
      const auto key = [](const WetInterval& w) { return std::make_tuple(w.block, w.edge, w.s_from, w.s_to); };
      ASSERT_EQ(b.intervals.size(), a.intervals.size());
      for (std::size_t i = 0; i < a.intervals.size(); ++i) EXPECT_EQ(key(b.intervals[i]), key(a.intervals[i]));
    }
  }
}

/// A block on its tip, over a plate, on which the structure's crest stands beside it.
TEST(WetFaces, AGapBetweenACornerAndAFaceIsAsNarrow) {
  const auto breached = [](double gap) {
    return wet_faces({{{{-4, 0}, {4, 0}, {4, 1}, {-4, 1}}, {{0, 1 + gap}, {3, 4}, {0, 12}, {-3, 4}}}}, Pool::upstream,
                     6)
        .breached;
  };
  for (const double gap : {0.0, 0.001, 0.02, 0.049}) EXPECT_FALSE(breached(gap)) << gap;
  for (const double gap : {0.061, 0.2}) EXPECT_TRUE(breached(gap)) << gap;
}

/// A block that has slipped on another, and turned a little: water on the step as far as the upper one's face.
TEST(WetFaces, TheStepOfASlipIsWetUpToTheUpperBlock) {
  for (const double turn : {0.0, 1e-9, 1e-6, 1e-4}) {
    for (const double slip : {0.0, 1e-12, 1e-8, 1e-6, 1e-5, 1e-3, 0.3, 1.0}) {
      const auto turned = [&](double x, double y) { return Point(x - turn * (y - 5), y + turn * (x - slip)); };
      const std::vector<std::vector<Point>> outlines = {
          {{0, 0}, {4, 0}, {4, 5}, {0, 5}},
          {turned(slip, 5), turned(4 + slip, 5), turned(4 + slip, 12), turned(slip, 12)}};
      double front = 0;
      double step = 0;
      for (const WetInterval& w : wet_faces({outlines}, Pool::upstream, 10).intervals) {
        const auto& o = outlines[at(w.block)];
        const auto e = at(w.edge);
        const double length = (w.s_to - w.s_from) * (o[(e + 1) % 4] - o[e]).norm();
        if (e == 3) front += length;
        if (w.block == 0 && w.edge == 2) step += length;
      }
      EXPECT_NEAR(front, 10, 1e-6) << slip << ' ' << turn;
      EXPECT_NEAR(step, slip, 1e-9 + 0.1 * turn) << slip << ' ' << turn;
    }
  }
}

/// A block that slides down a crack that dips: its face is wet to its foot, and the crack as far as it has left it.
TEST(WetFaces, TheMouthOfADippingCrackIsWetAsFarAsItsBlockHasSlid) {
  for (const double dip : {5, 20, 45}) {
    const Point down(std::cos(dip * std::numbers::pi / 180), -std::sin(dip * std::numbers::pi / 180));
    for (const double slip : {0.0, 1e-6, 1e-4, 1e-3, 0.02, 0.3}) {
      const Point foot = Point(0, 15) + slip * down;
      const std::vector<std::vector<Point>> outlines = {{{0, 0}, {20, 0}, Point(0, 15) + 12 * down, {0, 15}},
                                                        {foot, foot + 12 * down, {4 + foot.x(), 22}, {foot.x(), 22}}};
      double face = 0;
      double crack = 0;
      for (const WetInterval& w : wet_faces({outlines}, Pool::upstream, 21).intervals) {
        const auto& o = outlines[at(w.block)];
        const double length = (w.s_to - w.s_from) * (o[(at(w.edge) + 1) % 4] - o[at(w.edge)]).norm();
        if (w.block == 1 && w.edge == 3) face += length;
        if (w.block == 0 && w.edge == 2) crack += length;
      }
      EXPECT_NEAR(face, 21 - foot.y(), 1e-9) << dip << ' ' << slip;
      EXPECT_NEAR(crack, slip, 1e-9) << dip << ' ' << slip;
    }
  }
}

TEST(WetFaces, WhatStandsAboveTheSurfaceIsDryHoweverNear) {
  for (const double height : {-0.3, -1e-3, 1e-3, 0.01, 0.1}) {  // of a flat ledge over the level
    const std::vector<std::vector<Point>> outlines = {
        {{0, 0}, {6, 0}, {6, 12}, {3, 12}, {3, 8 + height}, {0, 8 + height}}};
    double ledge = 0;
    for (const WetInterval& w : wet_faces({outlines}, Pool::upstream, 8).intervals) {
      if (w.edge == 4) ledge += 3 * (w.s_to - w.s_from);
      if (w.edge == 5) EXPECT_NEAR((w.s_to - w.s_from) * (8 + height), std::min(8.0, 8 + height), 1e-9);
    }
    EXPECT_NEAR(ledge, height < 0 ? 3 : 0, 1e-9) << height;
  }
}

/// Clipper counts in whole numbers, which reach some 4,000 km far at the grid that it has near the origin.
TEST(WetFaces, WaterWetsTheSameWhereverTheModelStandsAndHoweverWideItIs) {
  const auto wet = [](const Point& way, double ground_m, double level_m) {
    std::vector<std::vector<Point>> outlines = {{{-ground_m, -1}, {ground_m, -1}, {ground_m, 0}, {-ground_m, 0}},
                                                {{0, 0}, {4, 0}, {4, 5}, {0, 5}},
                                                {{1, 5}, {4, 5}, {3, 12}, {2, 12}}};
    for (auto& outline : outlines) {
      for (Point& p : outline) p += way;
    }
    std::vector<double> lengths;
    for (const WetInterval& w : wet_faces({outlines}, Pool::upstream, way.y() + level_m).intervals) {
      const auto& o = outlines[at(w.block)];
      lengths.push_back((w.s_to - w.s_from) * (o[(at(w.edge) + 1) % 4] - o[at(w.edge)]).norm());
    }
    return lengths;
  };
  const std::vector<double> here = {9, 1, 1, 5, 5 * std::sqrt(50) / 7};
  for (const Point& way : {Point(0, 0), Point(4e5, -4e5), Point(5e6, 0), Point(-9.9e6, 9.9e6), Point(3, -9e6)}) {
    EXPECT_THAT(wet(way, 9, 10), testing::Pointwise(testing::DoubleNear(1e-6), here)) << way.transpose();
  }
  EXPECT_THAT(wet({0, 0}, 9.9e6, 10), testing::Pointwise(testing::DoubleNear(1e-6), {9.9e6, 1., 1., 5., here[4]}));
  EXPECT_EQ(wet({0, 0}, 9, 1e9).size(), 5U);
}

/// A wall on supports, with no ground below: what its foot rises by as it turns a little is no way past it.
TEST(WetFaces, AWallThatHasTurnedByRoundOffLetsNoWaterUnderIt) {
  for (const double turn : {0.0, 1e-16, 3e-16, -1e-15, 1e-14, -1e-13, 1e-12, -1e-10, 1e-8, -1e-6, 1e-4}) {
    for (const double x : {0.0, 0.05, -0.1, 1.0 / 3}) {
      for (const double low : {0.0, 0.1, -7.3}) {
        const auto turned = [&](double u, double v) { return Point(x + u - turn * v, low + v + turn * u); };
        const std::vector<std::vector<Point>> outlines = {{turned(0, 0), turned(8, 0), turned(8, 22), turned(0, 22)}};
        const WetFaces wet = wet_faces({outlines}, Pool::upstream, low + 20);
        EXPECT_FALSE(wet.breached) << turn << ' ' << x << ' ' << low;
        double front = 0;
        for (const WetInterval& w : wet.intervals) {
          EXPECT_EQ(w.edge, 3) << turn << ' ' << x << ' ' << low;
          front += 22 * (w.s_to - w.s_from);
        }
        EXPECT_NEAR(front, 20, 1e-12 + std::abs(turn)) << turn << ' ' << x << ' ' << low;
      }
    }
  }
}

}  // namespace
}  // namespace blockweir::hydrostatic::wet_faces_test
