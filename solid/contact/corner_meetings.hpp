// SPDX-License-Identifier: GPL-3.0-or-later
// Corners that meet: of all pairs of vertex and edge that describe one contact, the search keeps one.
#pragma once

#include <cstddef>
#include <vector>

#include "solid/contact/current_outlines.hpp"
#include "solid/contact/joint_openings.hpp"
#include "solid/contact/passing_corners.hpp"

namespace blockweir::solid {

/// In the order of their pairs of blocks, vertices and edges.
struct FoundContacts {
  std::vector<ContactPoint> all;
  std::vector<char> inherited;  ///< has it the memory of a contact of the step before?
};

class CornerMeetings {
 public:
  CornerMeetings(const CurrentOutlines& outlines, const JointOpenings& openings, PassingCorners& passing,
                 FoundContacts& found)
      : outlines_(outlines), openings_(openings), passing_(passing), found_(found) {}

  /// Corners that have passed each other a little behind the line of their faces go on as they are: pushed onto it at
  /// once, they would fly.
  void count_from_passing();
  /// A vertex that touches one edge of a block near a corner lies far behind the next one, which it has never met: only
  /// closed contacts, and of the others the least penetrated, may press from within, where it is within. One that lies
  /// beside a block's acute corner is behind the line of an edge there, and in nothing.
  void drop_edges_seen_from_within();
  /// Where two convex vertices meet, up to four vertex-edge candidates describe one contact. What the meeting has come
  /// to know stays with the one that is kept.
  void keep_one_of_each();

 private:
  [[nodiscard]] bool overlaps_at(const ContactPoint& c) const;
  [[nodiscard]] bool faces_outside(const ContactPoint& c) const;
  [[nodiscard]] int met_vertex(const ContactPoint& c) const;
  [[nodiscard]] bool may_pass(const ContactPoint& c) const;
  [[nodiscard]] bool passes_alone(const ContactPoint& c) const;
  [[nodiscard]] bool bound_overlap(const ContactPoint& a, const ContactPoint& b) const;
  void let_pass(std::vector<std::size_t>& kept_for);

  const CurrentOutlines& outlines_;
  const JointOpenings& openings_;
  PassingCorners& passing_;
  FoundContacts& found_;
};

}  // namespace blockweir::solid
