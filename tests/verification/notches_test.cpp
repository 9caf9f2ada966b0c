// SPDX-License-Identifier: GPL-3.0-or-later
// links: blockweir_independent solid_step bridge_scene_read
// Blocks that slide down a slope onto the floor at its foot: both are faces of one block, in a notch of any angle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"
#include "tests/independent/random_structures.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::test::notches_test {
namespace {

using Eigen::Vector2d;

/// The slope falls towards the origin, and the floor goes on from there.
struct Notch {
  double size_m;
  double fall_deg;
  double length;  ///< of the block, in sizes
  double friction_deg;
  double step_s;
  bool rigid;

  [[nodiscard]] Vector2d up() const {
    const double fall = fall_deg * std::numbers::pi / 180;
    return {-std::cos(fall), std::sin(fall)};
  }
  [[nodiscard]] Vector2d out() const { return {up().y(), -up().x()}; }

  [[nodiscard]] std::string scene() const {
    const auto text = [](const Vector2d& p) { return fmt::format("[{}, {}]", p.x(), p.y()); };
    const Vector2d top = 12 * size_m * up();
    const Vector2d foot = 3 * size_m * up();
    const Vector2d behind = foot + length * size_m * up();
    return fmt::format(R"(analysis = {{ duration_s = 1, step_s = {}, start = "unstressed", rigid = "{}" }}
joint = {{ friction_angle_deg = {} }}
material.m = {{ youngs_modulus_pa = 30e9, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }}
[[block]]
name = "ground"
material = "m"
fixed = true
vertices_m = [[{}, {}], [{}, {}], [{}, 0], [0, 0], {}]
[[block]]
name = "block"
material = "m"
vertices_m = [{}, {}, {}, {}]
)",
                       step_s, rigid ? "all" : "named", friction_deg, top.x(), -3 * size_m, 40 * size_m, -3 * size_m,
                       40 * size_m, text(top), text(foot), text(foot + size_m * out()), text(behind + size_m * out()),
                       text(behind));
  }

  [[nodiscard]] double depth_m(const Vector2d& p) const { return std::max(-p.y(), -out().dot(p)); }
};

TEST(Notches, WhatSlidesDownASlopeStandsOnTheFloorAtItsFoot) {
  for (int seed = 1; seed <= campaign(40); ++seed) {
    independent::Random random(static_cast<std::uint64_t>(seed), "notches");
    Notch notch{.size_m = random.between_orders(0.1, 10),
                .fall_deg = random.between(8, 80),
                .length = random.between(0.4, 2.5),
                .friction_deg = 0,
                .step_s = 0,
                .rigid = random.chance(0.6)};
    notch.friction_deg = random.between(0, notch.fall_deg / 2);
    notch.step_s = random.between(0.002, 0.01) * std::sqrt(notch.size_m);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, notch.scene()));
    solid::Solid solid(scene::read_text(notch.scene(), "notch").scene);
    double deepest_m = 0;
    int on_floor = 0;  // steps
    for (int n = 0; n < 4000 && on_floor < 200; ++n) {
      solid.advance(n * notch.step_s, (n + 1) * notch.step_s, {});
      for (const Vector2d& X : solid.blocks()[1].vertices) {
        const Vector2d p = solid.placements()[1].position(X);
        deepest_m = std::max(deepest_m, notch.depth_m(p));
        if (on_floor == 0 && p.y() < 1e-3 * notch.size_m) on_floor = 1;
      }
      if (on_floor > 0) ++on_floor;
    }
    EXPECT_LT(deepest_m, 1e-5 * notch.size_m);
    EXPECT_GT(on_floor, 0);
  }
}

}  // namespace
}  // namespace blockweir::test::notches_test
