// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_scene_read
// Wrong outlines, overlaps, blocks that nothing holds, loads beside their blocks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ctime>

#include "bridge/geometry/polygon.hpp"
#include "tests/samples.hpp"
#include "tests/unit/scene_sample.hpp"

namespace blockweir::scene_geometry_test {
using namespace blockweir::scene;
using sample::errors;
using sample::expect_error;
using sample::with;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

/// A scene of nothing but blocks, five lines each: the first one's [[block]] is on line 7, its vertices on line 10.
struct Outline {
  std::string name;
  std::string vertices;
  bool fixed = false;
};
std::string scene_of(const std::vector<Outline>& blocks, const std::string& more = "") {
  std::string scene =
      "analysis.duration_s = 1\n"
      "[material.m]\nyoungs_modulus_pa = 1e9\npoissons_ratio = 0.2\ndensity_kg_per_m3 = 2000\n";
  for (const Outline& b : blocks) {
    scene += fmt::format("\n[[block]]\nname = \"{}\"\nmaterial = \"m\"\nvertices_m = [{}]\nfixed = {}", b.name,
                         b.vertices, b.fixed);
  }
  return scene + "\n" + more;
}
const Outline ground{"ground", "[0, -1], [10, -1], [10, 0], [0, 0]", true};

TEST(SceneOutline, FewerThanThreeVerticesAreRefused) {
  expect_error(scene_of({ground, {"a", "[0, 0], [1, 0]"}}), 15, {"vertices_m in [[block]] \"a\"", "3 to 10000 points"});
}

TEST(SceneOutline, AVertexThatIsNoPointNamesItsLine) {
  expect_error(scene_of({ground, {"a", "[0, 0],\n[1, 0],\n[1, \"x\"]"}}), 17,
               {"y of point 3 of vertices_m in [[block]] \"a\" is 'x'; expected a finite number"});
  expect_error(scene_of({ground, {"a", "[0, 0],\n[1e8, 0],\n[1, 1]"}}), 16, {"within 1e7"});
}

TEST(SceneOutline, ARepeatedVertexIsRefused) {
  expect_error(scene_of({ground, {"a", "[0, 0],\n[1, 0],\n[1, 0],\n[0, 1]"}}), 17,
               {"block \"a\" has the vertex (1, 0) twice", "closes by itself"});
  expect_error(scene_of({ground, {"a", "[0, 0],\n[1, 0],\n[0, 1],\n[0, 0]"}}), 18, {"has the vertex (0, 0) twice"});
}

TEST(SceneOutline, AnOutlineThatCrossesItselfNamesWhere) {
  expect_error(scene_of({ground, {"a", "[0, 0], [2, 2], [2, 0], [0, 2]"}}), 15,
               {"block \"a\" crosses itself at (1, 1)", "(0, 0) to (2, 2) and (2, 0) to (0, 2)", "in order"});
  // With area left over, and at a vertex that touches another edge.
  expect_error(scene_of({ground, {"a", "[0, 0], [4, 0], [4, 3], [1, -0.5]"}}), 15, {"crosses itself at (1.42857, 0)"});
  expect_error(scene_of({ground, {"a", "[0, 0], [4, 0], [4, 3], [2, 0], [0, 3]"}}), 15, {"crosses itself at (2, 0)"});
}

TEST(SceneOutline, AnOutlineThatDoublesBackIsRefused) {
  expect_error(scene_of({ground, {"a", "[0, 0], [4, 0], [4, 2], [4, 4], [4, 1], [0, 1]"}}), 15,
               {"doubles back on itself at (4, 4)"});
  expect_error(scene_of({ground, {"a", "[0, 0], [4, 0], [2, 0], [2, 2]"}}), 15, {"doubles back on itself at (4, 0)"});
}

TEST(SceneOutline, AnOutlineWithoutAreaIsRefused) {
  expect_error(scene_of({ground, {"a", "[0, 0], [1, 1], [3, 3]"}}), 15, {"block \"a\" has no area"});
  expect_error(scene_of({ground, {"a", "[0, 0], [1, 0], [2, 0], [3, 0]"}}), 15, {"block \"a\" has no area"});
}

TEST(SceneOutline, OneThatIsLostInTheRoundOffOfItsPlaceIsRefused) {
  expect_error(scene_of({ground, {"a", "[0, 0], [1e-300, 0], [0, 1e-300]"}}), 15,
               {"is 1e-300 m wide", "at least 1e-6 m", "check the unit"});
  expect_error(scene_of({ground, {"a", "[1e6, 1e6], [1000000.01, 1e6], [1e6, 1000000.01]"}}), 15,
               {"is 0.01 m wide, 1e+06 m from the origin", "move the origin nearer"});
}

TEST(SceneOutline, ASliverOfOneToAMillionIsSound) {
  EXPECT_THAT(errors(scene_of({ground, {"a", "[0, 0], [1, 0], [1, 1e-6]"}})), IsEmpty());
}

TEST(SceneOutline, AClockwiseOneIsMendedAndSaidSo) {
  const ReadScene read = read_text(scene_of({ground, {"a", "[0, 0], [0, 1], [1, 1], [1, 0]"}}), "s.toml");
  ASSERT_THAT(read.notes, SizeIs(1));
  EXPECT_EQ(read.notes[0].text(), "s.toml:15: note: block \"a\" runs clockwise; it was taken the other way round");
  const auto& vertices = read.scene.blocks[1].vertices;
  EXPECT_EQ(geometry::signed_area(vertices), 1.0);
  EXPECT_EQ(vertices[0], Point(0, 0));
  EXPECT_EQ(vertices[1], Point(1, 0));
}

TEST(SceneOverlap, BlocksThatOverlapAreNamedWithTheirCommonArea) {
  expect_error(scene_of({ground, {"a", "[0, 0], [2, 0], [2, 1], [0, 1]"}, {"b", "[1.5, 0], [3, 0], [3, 1], [1.5, 1]"}}),
               17, {"blocks \"a\" and \"b\" overlap by 0.5 m2 near (1.75, 0.5)", "at most touch"});
}

TEST(SceneOverlap, ABlockInsideAnotherOverlaps) {
  expect_error(scene_of({ground, {"a", "[0, 0], [4, 0], [4, 4], [0, 4]"}, {"b", "[1, 1], [2, 1], [2, 2], [1, 2]"}}), 17,
               {"\"a\" and \"b\" overlap by 1 m2"});
  expect_error(scene_of({ground, {"a", "[0, 0], [4, 0], [4, 4], [0, 4]"}, {"b", "[0, 0], [4, 0], [4, 4], [0, 4]"}}), 17,
               {"overlap by 16 m2"});
}

TEST(SceneOverlap, OneDeeperThanAMillionthOfTheSizeIsFound) {
  const auto pair = [](double x) {
    return scene_of(
        {ground, {"a", "[0, 0], [1, 0], [1, 1], [0, 1]"}, {"b", fmt::format("[{0}, 0], [2, 0], [2, 1], [{0}, 1]", x)}});
  };
  EXPECT_THAT(errors(pair(1 - 1e-7)), IsEmpty());
  EXPECT_THAT(errors(pair(1 - 1e-5)), SizeIs(1));
}

TEST(SceneOverlap, BlocksThatTouchOrInterlockAreSound) {
  EXPECT_THAT(errors(scene_of({{"u", "[0, 0], [9, 0], [9, 5], [6, 5], [6, 2], [3, 2], [3, 5], [0, 5]", true},
                               {"in", "[3, 2], [6, 2], [6, 4], [3, 4]"},
                               {"lid", "[3, 4], [6, 4], [4.5, 6]"}})),
              IsEmpty());
}

TEST(SceneOverlap, SlantingSlabsAreToldApartByTheirLongestEdge) {  // their boxes overlap
  const auto slab = [](const char* name, double x) {
    return Outline{name, fmt::format("[{}, 0], [{}, 0], [{}, 9], [{}, 9]", x, x + 1, x + 10, x + 9)};
  };
  EXPECT_THAT(errors(scene_of({ground, slab("a", 0), slab("b", 1), slab("c", 2.5)})), IsEmpty());
  const auto found = errors(scene_of({ground, slab("a", 0), slab("b", 0.999), slab("c", 2.5)}));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0], HasSubstr("blocks \"a\" and \"b\" overlap by 0.009 m2"));
}

TEST(SceneOverlap, ASmallBlockOnALongSlopeIsSound) {  // rounding to the long one's size would sink it in
  EXPECT_THAT(errors(scene_of({{"slope", "[-2121, 707], [7778, -9192], [8485, -8485], [-1414, 1414]", true},
                               {"a",
                                "[0, 0], [0.353553390593, -0.353553390593], [0.494974746831, -0.212132034356], "
                                "[0.141421356237, 0.141421356237]"}})),
              IsEmpty());
}

/// rows x rows blocks in bond, far from the origin.
std::string wall(int rows) {
  std::vector<Outline> blocks{{"ground", "[99990, -1], [101000, -1], [101000, 0], [99990, 0]", true}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < rows; ++column) {
      const double x = 100000 + 3.7 * column + (row % 2) * 1.85;
      const double y = 1.3 * row;
      blocks.push_back({fmt::format("b{}-{}", row, column),
                        fmt::format("[{0}, {1}], [{2}, {1}], [{2}, {3}], [{0}, {3}]", x, y, x + 3.7, y + 1.3)});
    }
  }
  return scene_of(blocks);
}

/// The shortest of three readings, in seconds of the processor: others may hold it in between.
double reading_time(const std::string& scene) {
  double shortest = 1e300;
  for (int i = 0; i < 3; ++i) {
    const std::clock_t start = std::clock();
    EXPECT_THAT(errors(scene), IsEmpty());
    shortest = std::min(shortest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return shortest;
}

TEST(SceneOverlap, TenThousandBlocksAreNotComparedAllWithAll) {
  const double quarter = reading_time(wall(test::samples(50)));
  const double whole = reading_time(wall(test::samples(100)));
  RecordProperty("seconds", fmt::format("{:.3f} and {:.3f}", quarter, whole));
  EXPECT_LT(whole, 10 * quarter) << "four times the blocks: 4 if neighbours are compared, 16 if all are";
}

TEST(SceneHeld, ABlockThatWouldFallForEverIsRefused) {
  expect_error(scene_of({ground, {"a", "[20, 5], [21, 5], [21, 6], [20, 6]"}}), 12,
               {"block \"a\" is outside any support", "a fixed block or a support in y", "add a foundation"});
}

TEST(SceneHeld, ManyThatWouldFallAreOneErrorThatCountsThemAndNamesThree) {
  std::vector<Outline> blocks = {ground};
  for (int i = 0; i < 78; ++i) {
    blocks.push_back({fmt::format("b{}", i), fmt::format("[{0}, 5], [{1}, 5], [{1}, 6], [{0}, 6]", 20 + i, 21 + i)});
  }
  expect_error(
      scene_of(blocks), 12,
      {"78 blocks (\"b0\", \"b1\", \"b2\" and 75 more) are outside any support", "fixed_base = true to a [[wall]]"});
}

TEST(SceneHeld, WithoutGravityNothingFalls) {
  EXPECT_THAT(errors(with("duration_s = 1", "duration_s = 1\nanalysis.gravity_m_per_s2 = 0",
                          scene_of({{"a", "[20, 5], [21, 5], [21, 6], [20, 6]"}}))),
              IsEmpty());
}

TEST(SceneHeld, BelowCountsAtAnyDistanceAndThroughOtherBlocks) {
  EXPECT_THAT(errors(scene_of({ground,
                               {"high", "[9, 50], [12, 50], [12, 51], [9, 51]"},
                               {"on it", "[11, 51], [14, 51], [14, 52], [11, 52]"}})),
              IsEmpty());
}

TEST(SceneHeld, ABlockUnderAFixedOneIsNotHeldUnlessTheyTouch) {
  const Outline hanging{"hanging", "[0, -3], [1, -3], [1, -2], [0, -2]"};
  EXPECT_THAT(errors(scene_of({ground, hanging})), SizeIs(1));
  const Outline glued{"glued", "[0, -3], [1, -3], [1, -1], [0, -1]"};
  EXPECT_THAT(errors(scene_of({ground, glued})), IsEmpty());
  const Outline beside{"beside", "[10, -1], [11, -1], [11, 0], [10, 0]"};
  EXPECT_THAT(errors(scene_of({ground, beside})), IsEmpty());
}

TEST(SceneHeld, BlocksInAHollowAreJudgedByTheirOutlinesNotTheirBoxes) {
  // The hook's box reaches under the block, its outline does not.
  const Outline hook{"hook", "[0, 0], [1, 0], [1, 8], [5, 8], [5, 9], [0, 9]", true};
  EXPECT_THAT(errors(scene_of({hook, {"a", "[3, 2], [4, 2], [4, 3], [3, 3]"}})), SizeIs(1));
  EXPECT_THAT(errors(scene_of({hook, {"a", "[3, 10], [4, 10], [4, 11], [3, 11]"}})), IsEmpty());
}

TEST(SceneHeld, ASupportHoldsInY) {
  const Outline a{"a", "[20, 5], [21, 5], [21, 6], [20, 6]"};
  const std::string support = "[[support]]\nblock = \"a\"\npoint_m = [20, 5]\ndisplacement_{}_m = 0\n";
  EXPECT_THAT(errors(scene_of({ground, a}, fmt::format(fmt::runtime(support), "y"))), IsEmpty());
  EXPECT_THAT(errors(scene_of({ground, a}, fmt::format(fmt::runtime(support), "x"))), SizeIs(1));
}

TEST(SceneHeld, WaterHoldsWhatIsLighter) {
  const Outline a{"a", "[20, 0], [21, 0], [21, 6], [20, 6]"};
  const std::string water = "[water]\nupstream_level_m = 3\n";
  EXPECT_THAT(errors(scene_of({a}, water)), SizeIs(1));
  EXPECT_THAT(errors(with("2000", "500", scene_of({a}, water))), IsEmpty());
}

TEST(SceneLoads, PointsOutsideTheirBlockAreRefused) {
  expect_error(with("point_m = [0, 4]", "point_m = [0, 5]"), 37,
               {"point_m (0, 5) in [[point_load]] is outside block \"top\"", "a point in the block"});
  expect_error(with("point_m = [0, 0]", "point_m = [-1, 0]"), 33, {"point_m (-1, 0) in [[support]]", "\"base\""});
  EXPECT_THAT(errors(with("point_m = [0, 4]", "point_m = [1.5, 3]")), IsEmpty());
}

TEST(SceneLoads, AFacePressureOffOneEdgeIsRefused) {
  expect_error(with("to_m = [3, 4]", "to_m = [0, 4]"), 41,
               {"[[face_pressure]] from (3, 2) to (0, 4) does not lie on one edge of block \"top\""});
  expect_error(with("to_m = [3, 4]", "to_m = [3, 2]"), 39, {"begins and ends at the same point"});
  EXPECT_THAT(errors(with("to_m = [3, 4]", "to_m = [3, 3.1]")), IsEmpty());
}

TEST(SceneLoads, AForceMayBeAsLargeAsADamsWeight) {
  EXPECT_THAT(errors(with("force_n_per_m = [100, -200]", "force_n_per_m = [0, -2e7]")), IsEmpty());
  expect_error(with("force_n_per_m = [100, -200]", "force_n_per_m = [0, nan]"), 38, {"two finite numbers [x, y]"});
}

TEST(SceneLoads, LoadsAreStatedOnceAndWhole) {
  expect_error(with("force_n_per_m = [100, -200]\n", ""), 35, {"[[point_load]] has no force"});
  expect_error(with("force_n_per_m = [100, -200]", "force_n_per_m = [1, 2]\nforce_x_n_per_m = 3"), 35, {"twice"});
  expect_error(with("pressure_pa = 1000\n", ""), 39, {"[[face_pressure]] does not state one pressure"});
  expect_error(with("pressure_pa = 1000", "pressure_to_pa = 1000"), 39, {"does not state one pressure"});
  expect_error(with("displacement_x_m = 0\n", ""), 31, {"[[support]] holds nothing"});
}

TEST(SceneLoads, OnePointHasOnePath) {
  const auto with_another = [](const std::string& displacement) {
    return with("[[point_load]]",
                "[[support]]\nblock = \"base\"\npoint_m = [0, 0]\n" + displacement + "\n[[point_load]]");
  };
  expect_error(with_another("displacement_x_m = { from = 0, rate_per_s = 0.1, to = 0.05 }"), 35,
               {"[[support]] leads point (0, 0) of block \"base\" elsewhere than another [[support]] does"});
  EXPECT_THAT(errors(with_another("displacement_x_m = 0")), IsEmpty());
  EXPECT_THAT(errors(with_another("displacement_y_m = { from = 0, rate_per_s = 0.1, to = 0.05 }")), IsEmpty());
}

TEST(SceneLoads, APathBeginsWhereItsPointIsDrawn) {
  sample::expect_warning(with("displacement_x_m = 0", "displacement_x_m = 0.1"), 34,
                         {"displacement_x_m in [[support]] is 0.1 m at time 0: the point leaps there",
                          "displacement_x_m = { from = 0, rate_per_s = ..., to = 0.1 }"});
}

}  // namespace
}  // namespace blockweir::scene_geometry_test
