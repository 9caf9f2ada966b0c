// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_openfoam bridge_scene_read
// Which cells press on which part of an edge: ledges, berms, corners and slots of every size against the mesh, without
// interFoam. BLOCKWEIR_CAMPAIGN=N draws N structures at random.
#include <cstdlib>
#include <random>

#include "tests/samples.hpp"
#include "tests/unit/openfoam_shapes.hpp"

namespace blockweir::openfoam_edges_test {
namespace {

using namespace blockweir::openfoam;
using shapes::Blocks;
using testing::IsEmpty;

Polygon box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// By how much the force on a block is off, over what presses on it; the largest of all blocks.
double error(const Blocks& blocks, double upstream_m, double downstream_m = 0, int cells_in_depth = 20) {
  const scene::Scene scene = shapes::scene_of(blocks, upstream_m, downstream_m, cells_in_depth);
  const Grid grid = make_grid(scene);
  const auto exact = shapes::exact_forces(scene, grid);
  const auto meshed = shapes::meshed_forces(scene, grid);
  double largest = 0;
  for (std::size_t b = 0; b < exact.size(); ++b) {
    const double gross = std::max(exact[b].gross, meshed[b].gross);
    if (gross > 0) largest = std::max(largest, (exact[b].sum - meshed[b].sum).norm() / gross);
  }
  return largest;
}

TEST(OpenFoamEdges, ALedgeOfAnyThicknessLeavesNoPartOfAFaceDry) {
  for (const double cells : {0.03, 0.1, 0.2, 0.5, 0.9, 0.99, 1.0, 1.01, 1.1, 1.5, 1.6, 2.0, 2.3, 2.9, 3.0}) {
    const double t = 0.5 * cells;
    const Blocks blocks{{"ledge", box(-4, 0, 9, t)}, {"dam", box(0, t, 6, 11)}};
    EXPECT_LT(error(blocks, 10), 1e-9) << cells;
    EXPECT_LT(error(blocks, 10, 6.13), 1e-9) << cells;
    const scene::Scene scene = shapes::scene_of(blocks, 10, 0, 20);
    const double force = shapes::meshed_forces(scene, make_grid(scene))[2].sum.x();
    EXPECT_NEAR(force / (9810 * std::pow(10 - t, 2) / 2), 1, 1e-4) << cells;
  }
}

TEST(OpenFoamEdges, ABermIsPressedWhereverItLiesAgainstTheMeshAndTheSurface) {
  for (double y = 3; y < 9.96; y += 0.07) {
    EXPECT_LT(error({{"dam", {{0, 0}, {6, 0}, {6, 11}, {2, 11}, {2, y}, {0, y}}}}, 10), 1e-9) << y;
  }
}

TEST(OpenFoamEdges, SlopingFacesArePressedDownToTheCornerTheyEndIn) {
  for (const double lean : {-5.0, -2.0, -0.7, 0.7, 2.0, 5.0}) {
    for (const double t : {0.13, 0.4, 0.77}) {
      const Blocks blocks{{"ledge", box(-9, 0, 14, t)}, {"dam", {{0, t}, {6, t}, {6, 11}, {lean, 11}}}};
      EXPECT_LT(error(blocks, 10), 1e-6) << lean << ' ' << t;
    }
  }
}

TEST(OpenFoamEdges, ASlotIsPressedToItsEndHoweverNarrow) {
  for (const double gap : {0.051, 0.1, 0.3, 0.5, 0.77, 1.0, 1.2, 1.4, 1.5, 1.7}) {
    EXPECT_LT(error({{"toe", box(-2 - gap, 0, -gap, 4.1)}, {"dam", box(0, 0, 6, 11)}}, 10), 1e-9) << gap;
    EXPECT_LT(error({{"dam", box(0, 0, 6, 11)}, {"toe", box(6 + gap, 0, 8 + gap, 3)}}, 10, 5.3), 1e-9) << gap;
    EXPECT_LT(error({{"dam", {{0, 0}, {6, 0}, {6, 11}, {0, 11}, {0, 5 + gap}, {2, 5 + gap}, {2, 5}, {0, 5}}}}, 10),
              1e-9)
        << gap;
  }
}

TEST(OpenFoamEdges, JointsThatAreClosedAtTheStartStayTheCracksTheyAre) {
  const Polygon lower = box(0, 0, 6, 5);
  Polygon upper = box(0, 5, 6, 11);
  ElementRules rules{0.5, 0.05, {true, true}, {}, {}};
  rules.closed = closed_intervals({lower, upper}, rules);
  EXPECT_FALSE(rules.closed.empty());
  for (Point& p : upper) p.y() += 0.6;  // 1.2 cells: no water in the mesh yet
  const std::vector<Polygon> opened{lower, upper};
  for (const EdgeElement& e : edge_elements(Faces(opened), rules)) {
    const bool joint = std::abs(e.normal.y()) > 0.5 && e.middle().y() > 4 && e.middle().y() < 6;
    EXPECT_EQ(e.openness, joint ? 0 : 1) << e.middle().transpose();
    EXPECT_FALSE(e.slot);
  }
}

TEST(OpenFoamEdges, NoWaterIsLookedForBehindAThinPlate) {
  const std::vector<Polygon> outlines{box(0, 0, 4, 8), box(-1, 0, -0.9, 8)};
  const Faces faces(outlines);
  const SamplePoints samples =
      find_sample_points({{{0, 4}, {{-1, 0}}, 0, 3}}, faces, 0.5,
                         [](const std::vector<Point>& points) { return std::vector<double>(points.size(), 0); })[0];
  for (int k = 0; k < samples.count; ++k) EXPECT_GT(samples.at[static_cast<std::size_t>(k)].x(), -0.9);
}

TEST(OpenFoamEdges, LooseRockAtTheModelsEndsGoesOnAsHighAsItsBed) {
  scene::Scene scene = shapes::scene_of(
      {{"left", box(-20, 0, 3, 4)}, {"right", box(3, 0, 40, 4)}, {"dam", box(0, 4, 8, 15)}}, 14, 0, 20);
  for (const std::size_t b : {1, 2, 3}) scene.blocks[b].fixed = false;
  const Grid grid = make_grid(scene);
  EXPECT_DOUBLE_EQ(grid.ground_m, 4);
  EXPECT_DOUBLE_EQ(grid.site.structure_left_m, 0);
  EXPECT_DOUBLE_EQ(grid.site.structure_right_m, 8);
  const auto forces = shapes::meshed_forces(scene, grid);
  EXPECT_LT(grid.x.front(), -20);
  EXPECT_GT(grid.x.back(), 40);
  EXPECT_NEAR(forces[1].sum.x(), 0, 1e-6);
  EXPECT_NEAR(forces[1].sum.y() / (-9810 * 10 * 20), 1, 1e-9);
  EXPECT_NEAR(forces[2].gross, 0, 1e-6);
  EXPECT_NEAR(forces[3].sum.x() / (9810 * 100 / 2), 1, 1e-9);
  EXPECT_THAT(misfits(scene, grid), IsEmpty());
}

/// Ledges before and behind, a berm, a leaning face, a toe block with a slot: pressed right, or told.
TEST(OpenFoamEdges, StructuresDrawnAtRandomArePressedRightOrToldToBeTooFine) {
  const char* asked = std::getenv("BLOCKWEIR_CAMPAIGN");
  const int structures = asked != nullptr ? std::atoi(asked) : test::samples(60);
  int refused = 0;
  for (int seed = 0; seed < structures; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const double t = draw(0.06, 1.5);
    const double berm = draw(t + 1.3, 9);
    const double step = draw(0, 3);
    const double lean = draw(-1, 3);
    const double gap = draw(0.06, 2);
    const double end = 9 + draw(0, 4);
    Blocks blocks{
        {"ledge", box(-draw(1, 6), 0, end, t)},
        {"dam", {{0, t}, {8, t}, {8, 12}, {step + std::max(lean, 0.0), 12}, {step, berm}, {0, berm - draw(0, 1)}}}};
    // On the ledge or beyond it: still water takes no notice of strips that are narrower than a crack.
    const bool beyond = draw(0, 1) < 0.5;
    const double toe = beyond ? end + draw(0.3, 2) : draw(8 + gap + 0.3, std::max(end - 0.06, 8 + gap + 0.3));
    const bool has_toe = end > 8 + gap + 0.4 && draw(0, 1) < 0.7;
    if (has_toe) blocks.emplace_back("toe", box(8 + gap, t, toe, t + draw(0.2, 4)));
    const int cells = static_cast<int>(draw(10, 30));
    const double upstream = draw(9.2, 11.5);
    const double downstream = draw(0, 1) < 0.5 ? 0 : draw(t + 1, 8);
    const scene::Scene scene = shapes::scene_of(blocks, upstream, downstream, cells);
    const auto told = misfits(scene, make_grid(scene));
    if (!told.empty()) {
      ++refused;
      continue;
    }
    EXPECT_LT(error(blocks, upstream, downstream, cells), 1e-3) << "seed " << seed;
  }
  EXPECT_LT(refused, structures / 5 + 1);
}

}  // namespace
}  // namespace blockweir::openfoam_edges_test
