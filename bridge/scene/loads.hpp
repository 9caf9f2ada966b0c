// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says of loads beside weight and water: held points, forces, pressures, the motion of the ground.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "bridge/geometry/point.hpp"
#include "bridge/scene/time_table.hpp"

namespace blockweir::scene {

using geometry::Point;

/// The table of a scene that a load comes from.
enum class LoadOrigin { stated, silt, earthquake };

/// A point of a block that is held, or moved as its tables say, in x, in y or in both.
struct Support {
  int block = 0;
  Point point_m;
  std::optional<TimeTable> displacement_x_m;  ///< absent: free in x
  std::optional<TimeTable> displacement_y_m;
  bool operator==(const Support&) const = default;
};

struct PointLoad {
  int block = 0;
  Point point_m;
  TimeTable force_x_n_per_m;
  TimeTable force_y_n_per_m;
  bool operator==(const PointLoad&) const = default;
};

/// Pressure on a straight part of a block's outline, linear from one end to the other; turns with the block.
struct FacePressure {
  int block = 0;
  Point from_m;  ///< both ends lie on one edge of the block
  Point to_m;
  TimeTable pressure_from_pa;  ///< compression positive
  TimeTable pressure_to_pa;
  bool operator==(const FacePressure&) const = default;
};

/// Force on a straight part of a block's outline, linear from one end to the other, along the scene's axes.
struct LineLoad {
  int block = 0;
  Point from_m;  ///< both ends lie on one edge of the block
  Point to_m;
  std::array<TimeTable, 2> force_from_n_per_m2;  ///< x and y, a metre of the edge as the scene draws it
  std::array<TimeTable, 2> force_to_n_per_m2;
  LoadOrigin origin = LoadOrigin::stated;
  bool operator==(const LineLoad&) const = default;
};

/// Force on the volume of blocks, along the scene's axes.
struct BodyLoad {
  std::vector<int> blocks;         ///< indices into Scene::blocks
  bool per_mass = true;            ///< value is an acceleration [m/s2], else a force per volume [N/m3]
  std::array<TimeTable, 2> value;  ///< x and y
  LoadOrigin origin = LoadOrigin::stated;
  bool operator==(const BodyLoad&) const = default;
};

/// A straight part of a block's outline beyond which the ground goes on. At rest it is held; waves leave through it
/// (Lysmer and Kuhlemeyer 1969), and those of a base motion come in.
struct ViscousFace {
  int block = 0;
  Point from_m;  ///< along the outline, counter-clockwise
  Point to_m;
  int material = 0;  ///< of the ground beyond: index into Scene::materials

  [[nodiscard]] double length_m() const { return (to_m - from_m).norm(); }
  [[nodiscard]] Point normal() const {  ///< out of the block
    const Point along = (to_m - from_m).normalized();
    return {along.y(), -along.x()};
  }
  /// Else the ground is below it, and bears it.
  [[nodiscard]] bool is_side() const { return std::abs(normal().x()) > std::abs(normal().y()); }
  bool operator==(const ViscousFace&) const = default;
};

/// How the ground's acceleration acts: as an inertia force on all that can move, motions then being relative to the
/// base; or by moving fixed blocks and held points, the acceleration integrated twice.
enum class BaseForm { inertia, support };

struct BaseMotion {
  BaseForm form = BaseForm::inertia;
  TimeTable acceleration_x_m_per_s2 = TimeTable::constant(0);
  TimeTable acceleration_y_m_per_s2 = TimeTable::constant(0);
  std::string correction{};  ///< what was done to the records, in words; empty: nothing
  bool operator==(const BaseMotion&) const = default;
};

}  // namespace blockweir::scene
