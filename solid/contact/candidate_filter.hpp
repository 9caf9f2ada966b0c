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

class CandidateFilter {
 public:
  CandidateFilter(const CurrentOutlines& outlines, const JointOpenings& openings, PassingCorners& passing,
                  FoundContacts& found)
      : outlines_(outlines), openings_(openings), passing_(passing), found_(found) {}

  /// Corners that have passed each other slightly behind the line of their faces keep that offset: closed at once, they
  /// would be thrown off.
  void count_from_passing();
  /// A corner that has slid past a flat corner of the other outline lies on the face beyond, and the flat corner on its
  /// block. If one of the two contacts has a bond, it stands for both: what the faces differ in direction by rounded
  /// coordinates would pull the bond off.
  void keep_bonds_past_flat_corners();
  /// A vertex on one edge of a block near a corner is far behind the next edge, which it never touched. From inside
  /// only closed contacts may press, and of the others the one with least penetration. A vertex beside an acute corner
  /// is behind the line of an edge, but inside nothing.
  void drop_edges_seen_from_within();
  /// Where two convex vertices touch, up to four vertex-edge candidates describe one contact. The one that is kept
  /// takes over the memory of the contact.
  void keep_one_of_each();

 private:
  [[nodiscard]] bool overlaps_at(const ContactPoint& c) const;
  [[nodiscard]] bool faces_outside(const ContactPoint& c) const;
  [[nodiscard]] bool past_flat_corner(const ContactPoint& beyond, const ContactPoint& flat) const;
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
