// SPDX-License-Identifier: GPL-3.0-or-later
// Where blocks are in each other as a step ends, or next to each other: what contacts say, checked by the outlines.
#pragma once

#include <array>
#include <vector>

#include "solid/step/step_workspace.hpp"

namespace blockweir::solid {

/// A corner of one block and the face of another that it is in, or next to.
struct Meeting {
  int corner_block = 0;
  std::size_t vertex = 0;
  int face_block = 0;
  std::size_t edge = 0;
  Point corner = Point::Zero();  ///< m
  Point normal = Point::Zero();  ///< of the face, out of its block
  double gap = 0;                ///< m; infinite where the corner is behind the face's line but not in its block
};

class Meetings : StepPart {
 public:
  explicit Meetings(StepWorkspace& step) : StepPart(step) {}

  /// Of a contact. What rounded coordinates left at the start and what its slip has opened are no part of the gap, nor
  /// what its spring gives way.
  [[nodiscard]] Meeting of_contact(const ContactPoint& c);
  /// Of corners that no contact parts. Those that slide on one face, as two tips on the ground, may be pushed into each
  /// other by what parts them from it.
  [[nodiscard]] Meeting of_passing(const ContactPoint& c);
  /// Do they nearly touch: what pushes move is less? Or have they done so in the step, which has moved them by
  /// `moved_m` and leaves contacts `deepest_m` in each other: pushes move no more, and what is deeper is beside another
  /// side.
  [[nodiscard]] bool corners_touch(const ContactPoint& c, double moved_m, double deepest_m);

 private:
  struct Corner {
    int block;
    std::size_t vertex;
    std::array<std::size_t, 2> sides;  ///< edges before and after it
    std::vector<Point> points;         ///< the corner between its neighbours [m]
  };

  [[nodiscard]] Meeting of(const ContactPoint& c, bool at_corner);
  [[nodiscard]] std::size_t near_end(const ContactPoint& c) const;
  [[nodiscard]] Corner corner_now(int block, std::size_t vertex) const;
  [[nodiscard]] static Meeting of_corners(const Corner& vertex, const Corner& end);
  [[nodiscard]] Meeting checked(Meeting meeting, bool on_face);
  const std::vector<Point>& outline_now(int block, std::vector<Point>& corners) const;

  std::array<std::vector<Point>, 2> outlines_;  ///< of the corner's block and the face's
};

}  // namespace blockweir::solid
