// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_block
// Outlines as contacts see them: what a joint leaves out of both its blocks.
#include "solid/block/contact_outlines.hpp"

#include <gmock/gmock.h>

#include "solid/block/moving_parts.hpp"

namespace blockweir::solid::contact_outlines_test {
namespace {

using Outline = std::vector<std::pair<double, double>>;

/// A block on the ground from x = 0 to 9, with points between that both have. From the right the ground comes to them
/// by `beyond`.
std::vector<Outline> outlines(const std::vector<scene::Point>& base, const std::vector<scene::Point>& beyond) {
  scene::Scene scene;
  scene.materials.push_back({.name = "rock", .density_kg_per_m3 = 2500});
  scene::Block ground{.name = "ground", .vertices = {{-20, -10}, {30, -10}}, .fixed = true};
  scene::Block dam{.name = "dam", .vertices = {{0, 0}}};
  ground.vertices.insert(ground.vertices.end(), beyond.begin(), beyond.end());
  ground.vertices.insert(ground.vertices.end(), base.rbegin(), base.rend());
  ground.vertices.insert(ground.vertices.end(), {{0, 0}, {-20, 0}});
  dam.vertices.insert(dam.vertices.end(), base.begin(), base.end());
  dam.vertices.insert(dam.vertices.end(), {{9, 0}, {0, 12}});
  scene.blocks = {ground, dam};
  const MovingParts parts = make_moving_parts(scene);
  std::vector<Outline> found;
  for (std::size_t b = 0; b < 2; ++b) {
    Outline& outline = found.emplace_back();
    for (const ContactSide& side : parts.contact_outlines[b]) {
      const Point at = side.from + parts.blocks[b].centroid;
      outline.emplace_back(std::round(at.x() * 1e9) / 1e9, std::round(at.y() * 1e9) / 1e9);
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {  // sides go on from each other
      const auto& sides = parts.contact_outlines[b];
      EXPECT_EQ(sides[i].to, sides[(i + 1) % sides.size()].from);
    }
  }
  return found;
}

const Outline dam = {{0, 0}, {9, 0}, {0, 12}};

TEST(ContactOutlines, OfAJointThatIsStraightButForRoundingHaveItsEndsAlone) {
  const auto found = outlines({{3, 0.001}, {6, -0.002}}, {{30, 0.014}});
  EXPECT_EQ(found[1], dam);
  // The ground had no vertex at the toe.
  EXPECT_EQ(found[0], (Outline{{-20, -10}, {30, -10}, {30, 0.014}, {9, 0}, {0, 0}, {-20, 0}}));
}

TEST(ContactOutlines, KeepABend) {
  const auto found = outlines({{3, 0.001}, {6, -0.5}}, {{30, 0}, {9, 0}});
  EXPECT_EQ(found[1], (Outline{{0, 0}, {3, 0.001}, {6, -0.5}, {9, 0}, {0, 12}}));
}

TEST(ContactOutlines, LeaveOutWhatIsStraightBetweenBends) {
  const auto found = outlines({{2, -0.501}, {4, -1}, {6, -0.5}}, {{30, 0}, {9, 0}});
  EXPECT_EQ(found[1], (Outline{{0, 0}, {4, -1}, {6, -0.5}, {9, 0}, {0, 12}}));
}

}  // namespace
}  // namespace blockweir::solid::contact_outlines_test
