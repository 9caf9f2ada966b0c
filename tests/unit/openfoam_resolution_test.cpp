// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_openfoam bridge_scene_read
// Shapes that a mesh is too coarse for are refused before interFoam starts, with the mesh that it takes.
#include "tests/unit/openfoam_shapes.hpp"

namespace blockweir::openfoam_resolution_test {
namespace {

using namespace blockweir::openfoam;
using shapes::Blocks;
using testing::HasSubstr;
using testing::IsEmpty;

Polygon box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

std::vector<std::string> told(const Blocks& blocks, int cells_in_depth = 20, double downstream_m = 0) {
  const scene::Scene scene = shapes::scene_of(blocks, 10, downstream_m, cells_in_depth);
  return check_resolution(scene, make_grid(scene));
}

std::string refusal(const Blocks& blocks, int cells_in_depth = 20) {
  try {
    static_cast<void>(told(blocks, cells_in_depth));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(OpenFoamResolution, AWallOfLessThanTwoFullCellsBehindWaterIsRefused) {
  for (const double thickness : {0.1, 0.3, 0.5, 0.9}) {
    const std::string text = refusal({{"wall", box(0.1, 0, 0.1 + thickness, 11)}});
    EXPECT_THAT(text, HasSubstr("cells of 0.5 m do not resolve block \"wall\" at (0.1, ")) << thickness;
    EXPECT_THAT(text, HasSubstr("water would go through it")) << thickness;
  }
  for (const double thickness : {1.0, 1.3, 2.0}) {
    EXPECT_THAT(told({{"wall", box(0.1, 0, 0.1 + thickness, 11)}}), IsEmpty()) << thickness;
  }
}

TEST(OpenFoamResolution, TheCellsThatItNamesAreEnough) {
  const Blocks blocks{{"wall", box(0.1, 0, 0.7, 11)}};
  const std::string text = refusal(blocks);
  const std::string key = "; raise cells_in_depth in [fluid] to ";
  ASSERT_THAT(text, HasSubstr(key));
  EXPECT_THAT(refusal(blocks, std::stoi(text.substr(text.find(key) + key.size()))), "");
}

TEST(OpenFoamResolution, AWallThatNoMeshOfAReasonableSizeResolvesIsToldSo) {
  EXPECT_THAT(refusal({{"sheet", box(0, 0, 0.01, 11)}}), HasSubstr("no mesh of up to 500,000 cells does"));
}

TEST(OpenFoamResolution, ASlotWithABendIsRefused) {
  const Blocks bent{{"toe", {{-2.3, 0}, {-0.3, 0}, {-0.3, 2}, {-1.3, 2}, {-1.3, 4}, {-2.3, 4}}},
                    {"dam", {{0, 0}, {6, 0}, {6, 11}, {0, 11}, {0, 4}, {-1, 4}, {-1, 2.3}, {0, 2.3}}}};
  EXPECT_THAT(refusal(bent), HasSubstr("no water in the mesh reaches its wet face"));
}

TEST(OpenFoamResolution, AThinPlateWithTheSameWaterOnBothSidesIsFine) {
  EXPECT_THAT(told({{"dam", box(0, 0, 6, 11)}, {"plate", box(-5, 3, -2, 3.2)}}), IsEmpty());
  EXPECT_THAT(told({{"dam", box(0, 0, 6, 11)}, {"plate", box(-5, 3, -4.8, 6)}}), IsEmpty());
}

TEST(OpenFoamResolution, AThinSlabThatFloatsHalfUnderWaterIsFine) {
  for (const double bottom : {9.3, 9.6, 9.8}) {
    const Blocks blocks{{"dam", box(0, 0, 6, 11)}, {"slab", box(-5, bottom, -2, bottom + 0.8)}};
    EXPECT_THAT(told(blocks), IsEmpty()) << bottom;
  }
}

TEST(OpenFoamResolution, ACrestThinnerThanTwoCellsAboveTheWaterIsFine) {
  EXPECT_THAT(told({{"dam", {{0, 0}, {8, 0}, {8, 2}, {0.3, 12}, {0, 12}}}}), IsEmpty());
}

TEST(OpenFoamResolution, AThinParapetThatHoldsLittleWaterIsToldAndRuns) {
  const auto lines = told({{"dam", {{0, 0}, {8, 0}, {8, 9}, {0.7, 9}, {0.7, 11}, {0, 11}}}});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_THAT(lines[0], HasSubstr("do not resolve block \"dam\" at (0, 9."));
  EXPECT_THAT(lines[0], HasSubstr(" % of the force of still water on it would be wrong"));
}

}  // namespace
}  // namespace blockweir::openfoam_resolution_test
