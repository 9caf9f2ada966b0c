// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step
// Joints that are drawn almost straight, as survey points have them: columns settle on them.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/verification/campaign.hpp"
#include "tests/verification/scenes.hpp"

namespace blockweir::solid::flat_bends_test {
namespace {

/// Points of a joint over the width, whose slope changes at each by up to the bend [rad].
std::vector<Point> bent_line(test::Random& random, const Point& from, double width, double bend) {
  std::vector<Point> line{from};
  const double dip = random.between(-0.14, 0.14);
  const int pieces = random.integer(2, 4);
  for (int i = 1; i <= pieces; ++i) {
    const double along =
        (i + (i < pieces ? random.between(-0.3, 0.3) : 0)) * width / pieces + from.x() - line.back().x();
    line.push_back(line.back() + along * Point(1, std::tan(dip + random.between(-bend, bend))));
  }
  return line;
}

/// Of a few blocks, the lowest on level rock or on a bent line of it.
scene::Scene column(test::Random& random, double bend_rad) {
  auto scene = empty_scene();
  scene::JointLaw& joint = scene.default_joint;
  joint.friction_angle_deg = joint.residual_friction_angle_deg = random.between(25, 40);
  if (random.integer(0, 1) == 1) {
    joint.cohesion_pa = 1e6;
    joint.tension_strength_pa = 5e5;
  }
  scene.materials[0].youngs_modulus_pa = random.over_decades(1e9, 5e10);
  scene.materials[0].poissons_ratio = random.between(0, 0.35);
  const double width = random.over_decades(0.3, 30);
  const auto box = [&](double x, double y) { return Point(x * width, y * width); };
  auto below = bent_line(random, {0, 0}, width, bend_rad);
  std::vector<Point> rock{box(-3, -2), box(4, -2), box(4, 0)};
  rock.insert(rock.end(), below.rbegin(), below.rend());
  rock.push_back(box(-3, 0));
  add(scene, rock, true);
  const int blocks = random.integer(1, 4);
  for (int i = 1; i <= blocks; ++i) {
    const auto above = bent_line(random, box(0, i), width, i < blocks ? bend_rad : 0);
    auto outline = below;
    outline.insert(outline.end(), above.rbegin(), above.rend());
    add(scene, outline);
    below = above;
  }
  return scene;
}

TEST(FlatBends, ColumnsSettleOnThem) {
  for (int seed = 1; seed <= test::campaign(40); ++seed) {
    test::Random random(static_cast<unsigned>(seed));
    const double bend_deg = random.over_decades(1e-7, 3);
    Solid solid(column(random, bend_deg * std::numbers::pi / 180));
    ASSERT_NO_THROW(solid.settle({})) << "seed " << seed << ", " << bend_deg << " deg";
    double weight = 0;
    double borne = 0;
    for (const Block& block : solid.blocks()) weight += block.fixed ? 0 : block.mass_per_m() * 9.81;
    for (const ContactPoint& c : solid.contacts()) {
      if (std::min(c.vertex_block, c.edge_block) == 0) borne += c.force.norm();
    }
    if (solid.scene().default_joint.cohesion_pa > 0) continue;  // bonds may strain against each other
    EXPECT_GT(borne, weight * (1 - 1e-6)) << "seed " << seed << ", " << bend_deg << " deg";
    EXPECT_LT(borne, 1.5 * weight) << "seed " << seed << ", " << bend_deg << " deg";
  }
}

}  // namespace
}  // namespace blockweir::solid::flat_bends_test
