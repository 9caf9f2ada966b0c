// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of many blocks that tests and benchmarks share: pyramids, brick walls and dams, rock slopes. Blocks are rigid.
#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir {

/// Without blocks: concrete, friction alone.
inline scene::Scene large_scene(double friction_coefficient) {
  scene::Scene scene;
  scene.materials.push_back({"rock", 20e9, 0.2, 2000});
  scene.default_joint.friction_angle_deg = std::atan(friction_coefficient) * 180 / std::numbers::pi;
  scene.default_joint.residual_friction_angle_deg = scene.default_joint.friction_angle_deg;
  scene.analysis.rigid = scene::Rigid::all;
  scene.analysis.step_s = 1.0 / 60;
  return scene;
}

inline void add_block(scene::Scene& scene, std::vector<scene::Point> vertices, bool fixed = false) {
  scene::Block block;
  block.name = fmt::format("b{}", scene.blocks.size());
  block.vertices = std::move(vertices);
  block.fixed = fixed;
  scene.blocks.push_back(std::move(block));
}

inline std::vector<scene::Point> box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// base (base + 1)/2 cubes of 1 m, gaps of 2 % of the side between neighbours, each row half a block further in.
inline scene::Scene pyramid(int base) {
  scene::Scene scene = large_scene(0.6);
  const double pitch = 1.02;
  add_block(scene, box(-5, -1, base * pitch + 10, 1), true);
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) add_block(scene, box(row * pitch / 2 + i * pitch, row, 1, 1));
  }
  return scene;
}

/// A wall of about so many bricks of 0.4 m x 0.2 m, four times as many in a row as rows, each row half a brick off;
/// gaps of 2 % of the length between neighbours.
inline scene::Scene brick_wall(int bricks) {
  scene::Scene scene = large_scene(0.6);
  const double length = 0.4;
  const double height = 0.2;
  const double pitch = 1.02 * length;
  const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(bricks / 4.0))));
  const int columns = bricks / rows;
  add_block(scene, box(-1, -1, columns * pitch + 2, 1), true);
  for (int row = 0; row < rows; ++row) {
    const bool off = row % 2 == 1;  // such rows end in half bricks
    for (int i = 0; i < columns + (off ? 1 : 0); ++i) {
      const bool half = off && (i == 0 || i == columns);
      const double x = off && i > 0 ? (i - 0.5) * pitch : i * pitch;
      add_block(scene, box(x, row * height, half ? length - pitch / 2 : length, height));
    }
  }
  return scene;
}

/// About so many bricks of 2 m x 1 m without gaps, twice as broad as high; the water on its left face rises from half
/// its height by 4 m/s for 5 s.
inline scene::Scene brick_dam(int bricks) {
  scene::Scene scene = large_scene(0.7);
  const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(bricks))));
  const int columns = std::max(1, bricks / rows);
  add_block(scene, box(-1, -1, 2.0 * columns + 2, 1), true);
  for (int row = 0; row < rows; ++row) {
    const bool off = row % 2 == 1;  // such rows end in half bricks
    const auto face = static_cast<int>(scene.blocks.size());
    for (int i = 0; i < columns + (off ? 1 : 0); ++i) {
      add_block(scene, box(off && i > 0 ? 2 * i - 1 : 2 * i, row, off && (i == 0 || i == columns) ? 1 : 2, 1));
    }
    const auto pressure = [&](double height) {
      scene::TimeTable table{.time_s = {}, .value = {}};
      for (int i = 0; i <= 100; ++i) {
        table.time_s.push_back(0.05 * i);
        table.value.push_back(9810 * std::max(0.0, 0.5 * rows + 4 * 0.05 * i - height));
      }
      return table;
    };
    scene.face_pressures.push_back({.block = face,
                                    .from_m = scene::Point(0, row + 1),
                                    .to_m = scene::Point(0, row),
                                    .pressure_from_pa = pressure(row + 1),
                                    .pressure_to_pa = pressure(row)});
  }
  return scene;
}

/// About so many blocks of 1 m x 0.5 m on a plane that dips by 20 degrees, in rows that become shorter at toe and
/// crest: it stands with a friction coefficient above 0.364 and slides with one below.
inline scene::Scene rock_slope(int blocks, double friction_coefficient) {
  scene::Scene scene = large_scene(friction_coefficient);
  const double pitch = 1.02;
  const double height = 0.5;
  const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(blocks / 4.0))));
  const int columns = blocks / rows + rows / 2;  // of the lowest row
  const Eigen::Rotation2Dd dip(20 * std::numbers::pi / 180);
  const auto add = [&](std::vector<scene::Point> vertices, bool fixed) {
    for (scene::Point& p : vertices) p = dip * p;
    add_block(scene, std::move(vertices), fixed);
  };
  add(box(-columns * pitch / 2, -1, columns * pitch * 2, 1), true);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < columns - row; ++i) add(box(row * pitch / 2 + i * pitch, row * height, 1, height), false);
  }
  return scene;
}

}  // namespace blockweir
