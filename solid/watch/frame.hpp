// SPDX-License-Identifier: GPL-3.0-or-later
// One moment of a run for the result files: plain data, filled from the state, read by the writers.
#pragma once

#include <string>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::solid {

using scene::Point;

struct BlockRow {
  std::vector<Point> vertices_m;        ///< current outline
  std::vector<Point> displacement_m;    ///< one for each vertex
  std::vector<Point> velocity_m_per_s;  ///< one for each vertex
  Point centroid_m;                     ///< current
  Point centroid_displacement_m;
  Point centroid_velocity_m_per_s;
  double rotation_rad = 0;
  double rotation_rate_rad_per_s = 0;
  double stress_xx_pa = 0;  ///< tension positive, global axes
  double stress_yy_pa = 0;
  double stress_xy_pa = 0;
  Point water_force_n_per_m = Point::Zero();
  double water_moment_n = 0;  ///< about the scene's origin, counter-clockwise, N m per metre
  bool fixed = false;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(vertices_m, displacement_m, velocity_m_per_s, centroid_m, centroid_displacement_m,
            centroid_velocity_m_per_s, rotation_rad, rotation_rate_rad_per_s, stress_xx_pa, stress_yy_pa, stress_xy_pa,
            water_force_n_per_m, water_moment_n, fixed);
  }
};

struct ContactRow {
  Point point_m;
  Point normal;  ///< out of the edge's block
  int vertex_block = 0;
  int edge_block = 0;
  int joint = -1;                   ///< index into Scene::joints; -1 for the default joint
  int state = 0;                    ///< 0 open, 1 stick, 2 slip
  double bonded_length_m = 0;       ///< that still has cohesion or tension strength, weighted by what remains
  double gap_m = 0;                 ///< negative: penetration
  double slip_m = 0;                ///< since the start, signed along the edge
  double normal_force_n_per_m = 0;  ///< compression positive
  double shear_force_n_per_m = 0;
  double length_m = 0;  ///< length of joint that the contact represents

  template <class Archive>
  void serialize(Archive& archive) {
    archive(point_m, normal, vertex_block, edge_block, joint, state, bonded_length_m, gap_m, slip_m,
            normal_force_n_per_m, shear_force_n_per_m, length_m);
  }
};

struct PanelRow {
  int block = 0;
  Point from_m;
  Point to_m;
  double pressure_from_pa = 0;
  double pressure_to_pa = 0;
  bool in_crack = false;  ///< loaded by the crack's uplift law, not by open water

  template <class Archive>
  void serialize(Archive& archive) {
    archive(block, from_m, to_m, pressure_from_pa, pressure_to_pa, in_crack);
  }
};

struct BoltRow {
  Point from_m;  ///< present ends
  Point to_m;
  double force_n_per_m = 0;  ///< tension positive
  double elongation_m = 0;
  double plastic_elongation_m = 0;
  int state = 0;  ///< 0 elastic, 1 yielding, 2 slack

  template <class Archive>
  void serialize(Archive& archive) {
    archive(from_m, to_m, force_n_per_m, elongation_m, plastic_elongation_m, state);
  }
};

/// The mesh of a block.
struct MeshRow {
  int block = 0;
  std::vector<Point> nodes_m;  ///< current
  std::vector<Point> displacement_m;
  std::vector<Eigen::Vector3d> stress_pa;  ///< (xx, yy, xy) at the nodes, tension positive, global axes
  std::vector<std::array<int, 3>> triangles;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(block, nodes_m, displacement_m, stress_pa, triangles);
  }
};

struct Frame {
  double time_s = 0;
  double upstream_level_m = 0;        ///< NaN: no pool
  double downstream_level_m = 0;      ///< NaN: no pool
  double largest_displacement_m = 0;  ///< against the base
  Point base_displacement_m = Point::Zero();
  Point base_acceleration_m_per_s2 = Point::Zero();
  double kinetic_energy_j_per_m = 0;
  double strain_energy_j_per_m = 0;
  double potential_energy_j_per_m = 0;
  std::vector<BlockRow> blocks;
  std::vector<ContactRow> contacts;
  std::vector<PanelRow> panels;
  std::vector<BoltRow> bolts;
  std::vector<MeshRow> meshes;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(time_s, upstream_level_m, downstream_level_m, largest_displacement_m, base_displacement_m,
            base_acceleration_m_per_s2, kinetic_energy_j_per_m, strain_energy_j_per_m, potential_energy_j_per_m, blocks,
            contacts, panels, bolts, meshes);
  }
};

}  // namespace blockweir::solid
