// SPDX-License-Identifier: GPL-3.0-or-later
// Corners that the search allows to pass each other, and those left out because another contact describes them: checks
// whether a step has moved one into the other block.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "solid/contact/current_outlines.hpp"

namespace blockweir::solid {

class PassingCorners {
 public:
  /// Must outlive it.
  explicit PassingCorners(const CurrentOutlines& outlines) : outlines_(outlines) {}

  void begin_search();
  void add(const ContactPoint& c) { passing_.push_back(c); }
  /// Left out for what its corner has on the other block's edge.
  void begin_stood_for() { stood_for_.clear(); }
  void add_stood_for(const ContactPoint& c) { stood_for_.push_back(c); }
  void end_search();

  /// In the search before: did corners of these two blocks pass?
  [[nodiscard]] bool passed_before(const ContactPoint& c) const;
  /// In the step at hand.
  [[nodiscard]] bool did_enter(const ContactPoint& c) const;
  [[nodiscard]] bool presses_too(const ContactPoint& c) const;
  [[nodiscard]] bool did_miss(const ContactPoint& c) const;
  /// How near a contact is to being the one of its meeting: of corners that a step has taken into each other that edge
  /// is the entrance which the step has left least behind [m].
  [[nodiscard]] double nearness(const ContactPoint& c) const;

  /// ContactSearch says what these are.
  [[nodiscard]] bool entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts,
                             double left_m);
  [[nodiscard]] bool entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts,
                             double left_m, const std::vector<int>& island);
  [[nodiscard]] bool turned_on(const std::vector<Placement>& placements, double left_m);
  bool note_missed(const ContactPoint& c, double opened_m, const Point& expected, double slip_m, double least_m);
  /// Of the blocks of an island, by increasing number, with each other and with other blocks; each once.
  [[nodiscard]] std::vector<const ContactPoint*> of(const std::vector<int>& island) const;
  void forget_step() { entered_.clear(), turned_on_.clear(), missed_.clear(); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(passing_, stood_for_);
    if (Archive::is_loading::value) end_search();
  }

 private:
  [[nodiscard]] bool within(const std::vector<Point>& vertices, std::size_t v, const std::vector<Point>& edges,
                            std::size_t edge) const;
  bool note_entered(const std::vector<Placement>& placements, const std::vector<ContactPoint>& contacts, double left_m,
                    const ContactPoint& passing);
  const std::vector<Point>& outline(const std::vector<Placement>& placements, int block,
                                    std::vector<Point>& corners) const;

  const CurrentOutlines& outlines_;
  std::vector<ContactPoint> passing_;            ///< corners that may pass each other, left out
  std::vector<std::pair<int, int>> passing_of_;  ///< (block, index of a passing one), of both blocks, sorted
  std::vector<ContactPoint> passed_;             ///< those of the search before
  std::vector<ContactPoint> stood_for_;          ///< left out for what their corner has on the other block's edge
  std::array<std::vector<Point>, 2> moved_;      ///< outlines of such corners' blocks
  std::vector<ContactPoint> entered_;            ///< passing corners that entered a block in this step
  std::vector<ContactPoint> turned_on_;          ///< of those stood for, the ones that press too in it
  std::vector<ContactPoint> missed_;             ///< whose vertices leave the edge's end in it and do not press
};

}  // namespace blockweir::solid
