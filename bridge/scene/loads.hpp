// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of a scene besides weight and water: supports, forces, pressures, ground motion.
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

/// The kind of table in the scene that a load comes from.
enum class LoadOrigin { stated, silt, earthquake };

/// A point of a block that is held, or moved along a table, in x, in y or in both.
struct Support {
  int block = 0;
  Point point_m;
  std::optional<TimeTable> displacement_x_m;  ///< absent: free to move in x
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

/// Pressure on a straight part of a block's outline, linear between its ends; it turns with the block.
struct FacePressure {
  int block = 0;
  Point from_m;  ///< both ends lie on one edge of the block
  Point to_m;
  TimeTable pressure_from_pa;  ///< compression positive
  TimeTable pressure_to_pa;
  bool operator==(const FacePressure&) const = default;
};

/// Force on a straight part of a block's outline, linear between its ends; its direction stays fixed.
struct LineLoad {
  int block = 0;
  Point from_m;  ///< both ends lie on one edge of the block
  Point to_m;
  std::array<TimeTable, 2> force_from_n_per_m2;  ///< x and y components, per metre of the edge as drawn
  std::array<TimeTable, 2> force_to_n_per_m2;
  LoadOrigin origin = LoadOrigin::stated;
  bool operator==(const LineLoad&) const = default;
};

/// Body force on blocks; its direction stays fixed.
struct BodyLoad {
  std::vector<int> blocks;         ///< indices into Scene::blocks
  bool per_mass = true;            ///< value is an acceleration [m/s2], else a force per volume [N/m3]
  std::array<TimeTable, 2> value;  ///< x and y
  LoadOrigin origin = LoadOrigin::stated;
  bool operator==(const BodyLoad&) const = default;
};

/// A straight part of a block's outline beyond which the ground continues. It is held in the initial state. Later,
/// waves leave through it (Lysmer and Kuhlemeyer 1969) and those of a base motion enter.
struct ViscousFace {
  int block = 0;
  Point from_m;  ///< along the outline, counter-clockwise
  Point to_m;
  int material = 0;  ///< of the ground beyond the face: index into Scene::materials

  [[nodiscard]] double length_m() const { return (to_m - from_m).norm(); }
  [[nodiscard]] Point normal() const {  ///< out of the block
    const Point along = (to_m - from_m).normalized();
    return {along.y(), -along.x()};
  }
  /// Whether the ground is beside the block; otherwise it is below and carries it.
  [[nodiscard]] bool is_side() const { return std::abs(normal().x()) > std::abs(normal().y()); }
  bool operator==(const ViscousFace&) const = default;
};

/// How ground acceleration acts. inertia: as an inertia force on all moving blocks, with motion relative to the base.
/// support: fixed blocks and supports move by the acceleration integrated twice.
enum class BaseForm { inertia, support };

struct BaseMotion {
  BaseForm form = BaseForm::inertia;
  TimeTable acceleration_x_m_per_s2 = TimeTable::constant(0);
  TimeTable acceleration_y_m_per_s2 = TimeTable::constant(0);
  std::string correction{};  ///< how the records were corrected, for messages; empty: not at all
  bool operator==(const BaseMotion&) const = default;
};

}  // namespace blockweir::scene
