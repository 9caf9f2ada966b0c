// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_step bridge_scene_read
// Blocks with notches that fall into a box: none goes farther in a step than blocks are fast. Pushed out of overlaps
// that were none, some were metres away a step later, with the velocities of before.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "bridge/scene/read/read.hpp"
#include "solid/step/solid.hpp"
#include "tests/verification/campaign.hpp"

namespace blockweir::solid {
namespace {

using Shape = std::vector<Point>;

/// An L, a U, a T, a Z or a star, about a metre wide.
Shape notched(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const double w = 0.5 + 0.15 * share(random);
  const double h = 0.5 + 0.15 * share(random);
  const double t = 0.08 + 0.1 * share(random);
  switch (random() % 5) {
    case 0:
      return {{0, 0}, {w, 0}, {w, t}, {t, t}, {t, h}, {0, h}};
    case 1:
      return {{0, 0}, {w, 0}, {w, h}, {w - t, h}, {w - t, t}, {t, t}, {t, h}, {0, h}};
    case 2:
      return {{(w - t) / 2, 0}, {(w + t) / 2, 0}, {(w + t) / 2, h - t}, {w, h - t},
              {w, h},           {0, h},           {0, h - t},           {(w - t) / 2, h - t}};
    case 3:
      return {{0, 0}, {0.6 * w, 0}, {0.6 * w, h - t}, {w, h - t}, {w, h}, {0.4 * w, h}, {0.4 * w, t}, {0, t}};
    default: {
      Shape star;
      const int points = 2 * (3 + static_cast<int>(random() % 4));
      for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        star.emplace_back((i % 2 == 0 ? 0.35 : 0.16) * Point(std::cos(angle), std::sin(angle)));
      }
      return star;
    }
  }
}

std::string block(const std::string& name, const Shape& shape, const std::string& more) {
  std::string vertices;
  for (const Point& p : shape) vertices += fmt::format("{}[{}, {}]", vertices.empty() ? "" : ", ", p.x(), p.y());
  return fmt::format("[[block]]\nname = \"{}\"\nmaterial = \"m\"\n{}vertices_m = [{}]\n", name, more, vertices);
}

scene::Scene notched_fall(unsigned seed) {
  constexpr int columns = 5;
  constexpr int rows = 8;
  constexpr double apart_m = 1.08;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::string text =
      fmt::format(R"(analysis = {{ duration_s = 1.9, step_s = 0.005, start = "unstressed", rigid = "all" }}
joint = {{ friction_angle_deg = {} }}
material.m = {{ youngs_modulus_pa = 10e9, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }}
)",
                  15 + 30 * share(random));
  constexpr double w = columns * apart_m;
  text += block("floor", {{-1, -1}, {w + 1, -1}, {w + 1, 0}, {-1, 0}}, "fixed = true\n");
  text += block("left", {{-1, 0}, {0, 0}, {0, 10}, {-1, 10}}, "fixed = true\n");
  text += block("right", {{w, 0}, {w + 1, 0}, {w + 1, 10}, {w, 10}}, "fixed = true\n");
  for (int i = 0; i < columns * rows; ++i) {
    Shape shape = notched(random);
    const double turn = 2 * std::numbers::pi * share(random);
    const double scale = share(random) < 0.25 ? 0.2 : 1;
    Point middle(0, 0);
    for (const Point& p : shape) middle += p / static_cast<double>(shape.size());
    for (Point& p : shape) {
      const Point arm = scale * (p - middle);
      p = Point(std::cos(turn) * arm.x() - std::sin(turn) * arm.y(),
                std::sin(turn) * arm.x() + std::cos(turn) * arm.y()) +
          apart_m * Point(i % columns + 0.5, i / columns + 0.55);
    }
    text += block(fmt::format("b{}", i), shape, "");
  }
  return scene::read_text(text, "notched fall").scene;
}

/// Of a corner of any block [m/s].
double fastest(const Solid& solid) {
  double fastest = 0;
  for (std::size_t b = 0; b < solid.blocks().size(); ++b) {
    const Vector6 velocity = solid.velocity(b);
    fastest = std::max(fastest, velocity.head<2>().norm() + solid.blocks()[b].radius * std::abs(velocity[2]));
  }
  return fastest;
}

/// The farthest that a step has taken a block beyond what the fastest of all goes in it [m].
double farthest_beyond(const scene::Scene& scene) {
  Solid solid(scene);
  const double dt = scene.analysis.step_s;
  double beyond = 0;
  double before = 0;
  std::vector<BlockState> was = solid.states();
  for (long n = 0; static_cast<double>(n) * dt < scene.analysis.duration_s; ++n) {
    solid.advance(static_cast<double>(n) * dt, static_cast<double>(n + 1) * dt, {});
    const double now = fastest(solid);
    const double foreseen = std::max(before, now) * dt + scene.analysis.gravity_m_per_s2 * dt * dt;
    for (std::size_t b = 0; b < was.size(); ++b) {
      const Vector6 moved = solid.states()[b].displacement - was[b].displacement;
      const double way = moved.head<2>().norm() + solid.blocks()[b].radius * std::abs(moved[2]);
      beyond = std::max(beyond, way - foreseen);
    }
    was = solid.states();
    before = now;
  }
  return beyond;
}

/// BLOCKWEIR_CAMPAIGN=N: so many in place of a few.
TEST(NotchedFalls, MoveNoBlockFartherInAStepThanBlocksAreFast) {
  const char* asked = std::getenv("BLOCKWEIR_CAMPAIGN");
  const unsigned seeds = asked != nullptr ? static_cast<unsigned>(std::stoul(asked)) : 6;
  double worst = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const double beyond = farthest_beyond(notched_fall(seed));
    EXPECT_LE(beyond, 0.01) << "seed " << seed;
    worst = std::max(worst, beyond);
  }
  fmt::print("{} falls: up to {:.1e} m beyond\n", seeds, worst);
}

}  // namespace
}  // namespace blockweir::solid
