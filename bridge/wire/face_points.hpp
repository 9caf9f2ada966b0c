// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh corners on faces: the last three columns of a Motion, left out if there are none. C++17.
#pragma once

#include "bridge/wire/column_codec.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::wire {

inline void write_face_points(ColumnWriter& write, const Motion& m) {
  if (m.face_velocity.empty()) return;
  write(m.face_velocity);
  write(m.face_s);
  write(m.face_edge);
}

/// Throws BadMessage if the columns differ in length or hold an impossible number.
inline void read_face_points(ColumnReader& columns, Motion& m) {
  m.face_velocity.clear();
  m.face_s.clear();
  m.face_edge.clear();
  if (!columns.more()) return;
  const bool finite = columns.read<Finite>(m.face_velocity, "face_velocity");
  const bool fractions = columns.read<Fraction>(m.face_s, "face_s");
  columns.read<Any>(m.face_edge, "face_edge");
  if (!finite || !fractions) {
    throw BadMessage(fmt::format(
        "a velocity that is not finite, or a fraction outside 0 to 1, of a point of a face in window {}", m.window));
  }
  if (m.face_velocity.size() == m.face_s.size() && m.face_s.size() == m.face_edge.size()) return;
  throw BadMessage(fmt::format("{} velocities, {} fractions and {} edges of points of faces in window {}",
                               m.face_velocity.size(), m.face_s.size(), m.face_edge.size(), m.window));
}

}  // namespace blockweir::wire
