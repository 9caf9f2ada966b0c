// SPDX-License-Identifier: GPL-3.0-or-later
// What solid and fluid say to each other, as plain data. codec.hpp turns it into bytes and back.
// C++17: the OpenFOAM plugin includes this.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "bridge/wire/column.hpp"

namespace blockweir::wire {

/// Raised whenever a message changes its meaning; partners of different versions refuse each other.
inline constexpr std::uint32_t protocol_version = 10;

/// First message of either side. Everything in it must agree, but for `role` and `build`.
struct Hello {
  std::uint32_t protocol = protocol_version;
  std::string role;          ///< "solid", "hydrostatic", "openfoam"
  std::string build;         ///< program version
  std::string scene_digest;  ///< of the scene's text, overrides applied
  std::string schedule;      ///< "serial", "parallel", "improved"
  std::string units;         ///< "SI per metre"
  double window_s = 0;
  double duration_s = 0;
  std::uint64_t first_window = 0;  ///< other than 0 where a run is resumed
  std::vector<std::string> block_names;
  std::vector<std::uint32_t> vertex_counts;  ///< one a block
  std::vector<double> vertices_m;            ///< x0, y0, x1, y1, ... of all blocks in turn
};

/// What the fluid is to do on a Motion.
enum class Order : std::uint8_t {
  compute,           ///< step to the motion's time and answer with the pressures there
  save_and_compute,  ///< the same, after a checkpoint of the state before this motion
  save               ///< the checkpoint alone: the run is about to be stopped
};

/// Solid to fluid: where the blocks are, or will be, at `time_s`, which the fluid is to step to: one row of six a
/// block, in the scene's order. displacement (u0, v0 [m], r0 [rad], ex, ey, gxy) since the scene's outline, strains in
/// the block's own turned frame; velocity is its rate.
struct Motion {
  std::uint64_t window = 0;  ///< counted up by one each time
  double time_s = 0;         ///< never earlier than the one before
  Order order = Order::compute;
  Column<std::array<double, 6>> displacement;
  Column<std::array<double, 6>> velocity;
  /// Corners of meshes on the faces of their blocks, for a fluid that answers their bending: velocity (x, y) [m/s],
  /// fraction of the edge, block and edge. In order around each outline, from its first vertex. None for other fluids.
  Column<std::array<double, 2>> face_velocity;
  Column<double> face_s;
  Column<std::array<std::uint32_t, 2>> face_edge;

  /// Lets go of the frame that brought it.
  void release() {
    displacement.release();
    velocity.release();
    face_velocity.release();
    face_s.release();
    face_edge.release();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(window, time_s, displacement, velocity, face_velocity, face_s, face_edge);
  }
};

/// Fluid to solid: pressures [Pa, compression positive] on wet panels at the time of motion `window`.
/// A panel is the part s_from..s_to (fractions 0..1) of an edge of a block, edge i running from vertex i
/// to vertex i+1; pressure is linear between its two nodes. Columns have one length.
struct Load {
  std::uint64_t window = 0;
  double time_s = 0;
  /// While no block moves, the pressures stay as they are at all times before this one; time_s where that is not known.
  double holds_until_s = 0;
  double upstream_level_m = 0;    ///< NaN where there is no pool
  double downstream_level_m = 0;  ///< NaN where there is no pool
  Column<std::uint32_t> block;
  Column<std::uint32_t> edge;
  Column<double> s_from;
  Column<double> s_to;
  Column<double> pressure_from_pa;
  Column<double> pressure_to_pa;
  std::uint32_t cracks_from = 0;  ///< panels from this index on lie in cracks, those before on open water
  bool breached = false;          ///< open water has found a way past the structure
  /// The fluid's added mass on each block's rigid motion, by which its forces answer an acceleration: upper half
  /// (xx, xy, xr, yy, yr, rr) [kg/m, kg, kg m] of a symmetric matrix of translation x, y and rotation about the block's
  /// centroid where it is now. One row a block, zeros where the water does not reach, or none at all. A fluid that
  /// answers strains and bending has more rows: the strains (ex, ey, gxy) of each block, then (x, y, nothing) of each
  /// point of the motion's faces. Blocks with such points have their mass there alone.
  Column<std::array<double, 6>> added_mass;
  /// What blocks that push the same water do to each other: row by row, the force on the first row of `coupled` by a
  /// unit acceleration of the second, both as in added_mass. Each pair once, or none at all.
  Column<std::array<std::uint32_t, 2>> coupled;
  Column<std::array<double, 9>> added_mass_between;

  /// Lets go of the frame that brought it.
  void release() {
    block.release();
    edge.release();
    s_from.release();
    s_to.release();
    pressure_from_pa.release();
    pressure_to_pa.release();
    added_mass.release();
    coupled.release();
    added_mass_between.release();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(window, time_s, holds_until_s, upstream_level_m, downstream_level_m, block, edge, s_from, s_to,
            pressure_from_pa, pressure_to_pa, cracks_from, breached, added_mass, coupled, added_mass_between);
  }
};

/// The run is over; the partner may leave.
struct Farewell {
  std::string reason;
};

/// The sender cannot go on; the text is for the user.
struct Failure {
  std::string text;
};

/// The sender still computes what it owes, and has come further since it last said so. Whoever waits waits on.
struct Progress {
  std::string text;  ///< how far it has come, for the user: "window 333, 3.31 s: 4000 solutions so far"
};

}  // namespace blockweir::wire
