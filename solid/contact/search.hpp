// SPDX-License-Identifier: GPL-3.0-or-later
// Narrow phase: which vertices may touch which edges in the coming step, and what they remember.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "solid/block/parts.hpp"
#include "solid/contact/contact_point.hpp"
#include "solid/contact/joint_laws.hpp"
#include "solid/contact/neighbours.hpp"

namespace blockweir::solid {

/// Vertex to edge is the one kind of contact; edge to edge is two of them, at the ends of the overlap; where a
/// convex vertex meets a convex vertex the entrance edge, the one less penetrated, stands for both.
class ContactSearch {
 public:
  /// Gaps up to the reach are contacts in waiting. Two blocks may each move in a step, one towards the other.
  static constexpr double reach_per_move = 2.5;
  /// The farthest that a block among others may turn in a step: which vertices may meet which edges holds about as long
  /// [rad].
  static constexpr double most_turn = 0.05;
  /// The reach begins with `reach_m` and grows with what blocks move, up to `farthest_reach_m`.
  ContactSearch(const Parts& parts, const JointLaws& laws, double size_m, double reach_m, double farthest_reach_m);

  /// Contacts for a step that starts from `placements`; a contact that was in `contacts` keeps its memory, one
  /// that takes over its place (the vertex passed to the next edge, or its twin across the joint) inherits it.
  void update(const std::vector<Placement>& placements, std::vector<ContactPoint>& contacts);

  /// Outlines in the scene are known to this only [m]: points so near are one. True where they were not before, and the
  /// search begins anew.
  [[nodiscard]] bool rounds_to(double rounding_m);

  /// Corners that slide over each other do not catch on steps of up to `give_m`, by which blocks strain and contact
  /// springs give way.
  void passes_steps_of(double give_m) { give_ = std::max(2 * coincidence_, give_m); }

  /// Did a step that moved a vertex so far stay within what was looked at? Two blocks may move towards each other. If
  /// not, the next search looks farther.
  [[nodiscard]] bool covers(double moved_m);

  /// Has a step to these placements taken a corner that was let pass into the block that it met? If so, the next search
  /// from the same start keeps its contact. What one of `contacts`, as the step has
  /// them, holds on another edge of that block has not, however far its spring lets it in. Of all
  /// blocks, or of those of an island, by increasing number.
  [[nodiscard]] bool entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts);
  [[nodiscard]] bool entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts,
                             const std::vector<int>& island);
  /// Has it turned two faces onto each other at corners of which one was left out for the other? If so, the next search
  /// from the same start keeps both.
  [[nodiscard]] bool turned_on(const std::vector<Placement>& placements);
  /// The step is made: the next one begins with none that have.
  void forget_entered() { entered_.clear(), turned_on_.clear(); }

  [[nodiscard]] long broad_searches() const { return broad_searches_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(corners_at_pairs_, pairs_, broad_searches_, reach_, passing_, stood_for_, coincidence_, opened_at_pairs_,
            parted_);
    if (Archive::is_loading::value) sort_passing();
  }

 private:
  static constexpr double closing = 2 * most_turn;  ///< rad by which a face may turn onto an edge in a step
  /// Pairs stay valid while no block has moved half of it [m].
  [[nodiscard]] double margin() const { return 2 * reach_; }
  void refresh_pairs(const std::vector<Placement>& placements);
  void note_openings(const std::vector<ContactPoint>& contacts);
  [[nodiscard]] double opening(int block_a, int block_b) const;
  [[nodiscard]] double opening(const ContactPoint& c) const { return laws_[c.law].dilation_m(c.slip_m); }
  [[nodiscard]] bool slips_on(const ContactPoint& c) const { return laws_[c.law].dilation > 0 && c.has_touched(); }
  [[nodiscard]] double slip_since(const ContactPoint& was) const;
  void remember_slips(const std::vector<ContactPoint>& parting);
  void vertices_on_edges(int vertex_block, int edge_block);
  void find_planes();
  [[nodiscard]] int law_on(int vertex_block, std::size_t vertex, int edge_block, std::size_t edge,
                           const Point& t) const;
  void drop_edges_seen_from_within();
  [[nodiscard]] bool overlaps_at(const ContactPoint& c) const;
  [[nodiscard]] bool faces_outside(const ContactPoint& c) const;
  [[nodiscard]] double nearness(const ContactPoint& c) const;
  void keep_one_of_each_meeting();
  void let_pass(std::vector<std::size_t>& kept_for);
  [[nodiscard]] bool passes_alone(const ContactPoint& c) const;
  void count_from_passing();
  [[nodiscard]] const Point& vertex_of(const ContactPoint& c) const;
  [[nodiscard]] std::pair<Point, Point> edge_of(const ContactPoint& c) const;
  [[nodiscard]] int met_vertex(const ContactPoint& c) const;
  [[nodiscard]] bool may_pass(const ContactPoint& c) const;
  [[nodiscard]] bool bound_overlap(const ContactPoint& a, const ContactPoint& b) const;
  [[nodiscard]] bool within(const std::vector<Point>& vertices, std::size_t v, const std::vector<Point>& edges,
                            std::size_t edge) const;
  void sort_passing();
  [[nodiscard]] bool did_enter(const ContactPoint& c) const;
  bool note_entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts,
                    const ContactPoint& passing);
  const std::vector<Point>& outline(const std::vector<Placement>& placements, int block,
                                    std::vector<Point>& corners) const;
  [[nodiscard]] bool presses_too(const ContactPoint& c) const;
  [[nodiscard]] Point apart(const std::vector<Placement>& placements, const ContactPoint& c) const;
  void inherit(const std::vector<Placement>& placements, std::vector<ContactPoint>& old);
  void count_from_start(ContactPoint& c) const;
  [[nodiscard]] bool of_one_joint(const ContactPoint& a, const ContactPoint& b) const;

  const Parts& parts_;
  const JointLaws& laws_;
  std::vector<std::vector<int>> planes_;     ///< that each side lies on, by its law; empty where there are none
  bool dilates_;                             ///< does any joint?
  double reach_;                             ///< m
  double farthest_reach_;                    ///< m
  double coincidence_;                       ///< m, closer points are one
  double give_;                              ///< m, by which corners may be past each other and still pass
  std::vector<std::vector<Point>> corners_;  ///< current outlines of the scene's blocks
  std::vector<Box> boxes_;                   ///< current, by `reach`
  std::vector<std::vector<Point>> corners_at_pairs_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<ContactPoint> found_;
  std::vector<char> inherited_;
  std::vector<ContactPoint> passing_;            ///< corners that may pass each other, left out
  std::vector<std::pair<int, int>> passing_of_;  ///< (block, index of a passing one), of both blocks, sorted
  std::vector<ContactPoint> passed_;             ///< those of the search before
  std::vector<ContactPoint> stood_for_;          ///< left out for what their corner has on the other block's edge
  std::array<std::vector<Point>, 2> outlines_;   ///< of such corners' blocks
  std::vector<ContactPoint> entered_;            ///< of passing ones, those that did not in the step at hand
  std::vector<ContactPoint> turned_on_;          ///< of those stood for, the ones that press too in it
  // Of joints that dilate; empty where none does.
  std::vector<std::pair<std::pair<int, int>, double>> openings_;  ///< of pairs, at which their faces still touch [m]
  std::vector<double> opened_;                                    ///< the largest of each block
  std::vector<double> opened_at_pairs_;
  std::vector<ContactPoint> parted_;  ///< contacts out of reach: what their joints remember
  long broad_searches_ = 0;
};

}  // namespace blockweir::solid
