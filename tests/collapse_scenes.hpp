// SPDX-License-Identifier: GPL-3.0-or-later
// Walls that gravity tips over when it is tilted, and heaps of stones that fall: shared by tests and benchmarks.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>

#include "bridge/scene/read/read.hpp"

namespace blockweir::test {

/// Rigid blocks in steps of 0.01 s, that start where they are drawn, without stress.
inline scene::Scene collapse(const std::string& blocks, double duration_s, double tilt_deg, double friction_deg) {
  return scene::read_text(fmt::format(R"([analysis]
duration_s = {}
step_s = 0.01
start = "unstressed"
rigid = "all"
max_displacement_ratio = 0.05
gravity_tilt_deg = {}
[material.stone]
youngs_modulus_pa = 10e9
poissons_ratio = 0.2
density_kg_per_m3 = 2200
[joint]
friction_angle_deg = {}
{})",
                                      duration_s, tilt_deg, friction_deg, blocks),
                          "collapse")
      .scene;
}

/// Bricks of half a metre's height in running bond, on ground.
inline std::string wall(int rows, int columns, double brick_length_m) {
  return fmt::format(R"([[block]]
name = "ground"
material = "stone"
fixed = true
vertices_m = [[-60, -2], [60, -2], [60, 0], [-60, 0]]
[[wall]]
name = "b"
material = "stone"
rows = {}
columns = {}
brick_length_m = {}
brick_height_m = 0.5
bond = "running"
)",
                     rows, columns, brick_length_m);
}

inline std::string heap(int stones, unsigned seed) {
  return fmt::format(
      "[[heap]]\nname = \"s\"\nmaterial = \"stone\"\nwidth_m = {}\nsize_m = 0.9\nblocks = {}\nseed = {}\n",
      std::sqrt(stones), stones, seed);
}

/// Two seconds of a wall under tilted gravity or, of every third seed, of a heap: 60 to 290 blocks.
inline scene::Scene random_fall(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const double friction_deg = 15 + 30 * share(random);
  const int blocks = 60 + static_cast<int>(230 * share(random));
  const int columns = 2 + static_cast<int>(8 * share(random));
  const double brick_m = 0.6 + share(random);
  const double tilt_deg = 10 + 20 * share(random);
  if (seed % 3 == 0) return collapse(heap(blocks, seed), 2, 0, friction_deg);
  return collapse(wall(blocks / columns, columns, brick_m), 2, tilt_deg, friction_deg);
}

}  // namespace blockweir::test
