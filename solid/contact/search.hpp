// SPDX-License-Identifier: GPL-3.0-or-later
// Narrow phase: which vertices may touch which edges in the coming step, and what they remember.
#pragma once

#include <utility>
#include <vector>

#include "solid/contact/candidate_filter.hpp"
#include "solid/contact/current_outlines.hpp"
#include "solid/contact/joint_laws.hpp"
#include "solid/contact/joint_openings.hpp"
#include "solid/contact/near_pairs.hpp"
#include "solid/contact/passing_corners.hpp"

namespace blockweir::solid {

/// The order in which contacts are found and kept.
[[nodiscard]] bool precedes(const ContactPoint& a, const ContactPoint& b);
[[nodiscard]] bool of_lower_pair(const ContactPoint& a, const ContactPoint& b);

/// Vertex to edge is the only kind of contact. Edge to edge is two of them, at the ends of the overlap. Vertex to
/// vertex, if both are convex, is a contact with the entrance edge, the one less penetrated.
class ContactSearch {
 public:
  static constexpr double reach_per_move = NearPairs::reach_per_move;
  static constexpr double most_turn = most_turn_in_step;
  /// The reach begins with `reach_m` and grows with what blocks move, up to `farthest_reach_m`.
  ContactSearch(const MovingParts& parts, const JointLaws& laws, double size_m, double reach_m,
                double farthest_reach_m);
  ContactSearch(const ContactSearch&) = delete;
  ContactSearch& operator=(const ContactSearch&) = delete;

  /// Contacts for a step that starts from `placements`; a contact that was in `contacts` keeps its memory, one
  /// that takes over its place (the vertex passed to the next edge, or its twin across the joint) inherits it.
  void update(const std::vector<Placement>& placements, std::vector<ContactPoint>& contacts);

  /// Outlines in the scene are known to this only [m]: points so near are one. True where they were not before, and the
  /// search begins anew.
  [[nodiscard]] bool rounds_to(double rounding_m) { return outlines_.rounds_to(rounding_m); }

  /// Until then blocks are as drawn, and only faces that touch lie on each other: others have no bond. From then on
  /// those do that have turned a little; and corners that slide over each other do not catch on steps of up to
  /// `give_m`, by which blocks strain and contact springs give way.
  void begin_motion(double give_m) {
    as_drawn_ = false;
    outlines_.give_way_by(give_m);
  }

  /// Did a step that moved a vertex so far stay within what was looked at? Two blocks may move towards each other. If
  /// not, the next search looks farther.
  [[nodiscard]] bool covers(double moved_m) { return pairs_.covers(moved_m); }

  /// Whether a step to these placements has moved a passing corner into the other block. If so, the next search from
  /// the same start keeps its contact. Not for a corner that one of `contacts`, as in the step, holds on another
  /// edge of that block, however far its spring lets it in, and not by less than `left_m`: so deep the step leaves
  /// contacts in each other, too, for pushes to part. For all blocks, or those of an island, by increasing number.
  [[nodiscard]] bool entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts,
                             double left_m) {
    return passing_.entered(placements, contacts, left_m);
  }
  [[nodiscard]] bool entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts,
                             double left_m, const std::vector<int>& island) {
    return passing_.entered(placements, contacts, left_m, island);
  }
  /// Has it turned two faces onto each other at corners of which one was left out for the other? If so, the next search
  /// from the same start keeps both.
  [[nodiscard]] bool turned_on(const std::vector<Placement>& placements, double left_m) {
    return passing_.turned_on(placements, left_m);
  }
  /// Had a vertex that pressed left the edge by its end before it came to it? `expected`: its way (towards the edge,
  /// along it) by the velocities that the step began with, `slip_m` the way along it in the step. What comes no nearer
  /// than by `least_m` is left as it is. If so, the next search from the same start leaves the contact out.
  [[nodiscard]] bool missed(const ContactPoint& c, const Point& expected, double slip_m, double least_m) {
    return passing_.note_missed(c, openings_.of(c), expected, slip_m, least_m);
  }
  /// Corners near each other that are no contact: an island's, as the last search found them.
  [[nodiscard]] std::vector<const ContactPoint*> passing(const std::vector<int>& island) const {
    return passing_.of(island);
  }
  /// The step is made: the next one begins with none that have.
  void forget_step() { passing_.forget_step(); }

  /// How far blocks that are near each other are in each other by their outlines [m]; `known_m` if no more. Until the
  /// next search, placements are where it looked last or a step from there.
  [[nodiscard]] double overlap_m(const std::vector<Placement>& placements, double known_m);

  /// Blocks so near each other that they may touch.
  [[nodiscard]] const std::vector<std::pair<int, int>>& near_pairs() const { return pairs_.all(); }

  [[nodiscard]] long broad_searches() const { return pairs_.searches(); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(pairs_, passing_, outlines_, openings_);
  }

 private:
  void vertices_on_edges(int vertex_block, int edge_block);
  void find_planes();
  [[nodiscard]] int law_on(int vertex_block, std::size_t vertex, int edge_block, std::size_t edge,
                           const Point& t) const;
  [[nodiscard]] Point apart(const std::vector<Placement>& placements, const ContactPoint& c) const;
  void inherit(const std::vector<Placement>& placements, std::vector<ContactPoint>& old);

  const MovingParts& parts_;
  const JointLaws& laws_;
  CurrentOutlines outlines_;
  JointOpenings openings_{laws_, outlines_};
  NearPairs pairs_;
  PassingCorners passing_{outlines_};
  FoundContacts found_;
  bool as_drawn_ = true;
  std::vector<std::vector<int>> planes_;  ///< that each side lies on, by its law; empty where there are none
};

}  // namespace blockweir::solid
