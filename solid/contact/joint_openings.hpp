// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that dilate: their faces touch at a distance, and the slip belongs to the joint. It is kept while the joint is
// open, passed to all its contacts, and found again when blocks separate and touch again.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "solid/contact/current_outlines.hpp"
#include "solid/contact/joint_laws.hpp"

namespace blockweir::solid {

class JointOpenings {
 public:
  /// Both must outlive it.
  JointOpenings(const JointLaws& laws, const CurrentOutlines& outlines);

  /// How far apart the faces of joints still touch, whose contacts the last search has found.
  void note(const std::vector<ContactPoint>& contacts);
  /// The largest of a pair's contacts [m].
  [[nodiscard]] double between(int block_a, int block_b) const;
  [[nodiscard]] double of(const ContactPoint& c) const { return laws_[c.law].dilation_m(c.slip_m); }
  /// Of a block's joints [m].
  [[nodiscard]] double largest_m(std::size_t block) const { return opened_[block]; }
  /// By how much that has grown since pairs were found [m].
  [[nodiscard]] double since_pairs_m(std::size_t block) const { return opened_[block] - opened_at_pairs_[block]; }
  void note_pairs() { opened_at_pairs_ = opened_; }

  [[nodiscard]] bool slips_on(const ContactPoint& c) const { return laws_[c.law].dilation > 0 && c.has_touched(); }
  /// Slip of a contact that was closed last at its anchor: while it is open it goes on with the blocks, as the teeth of
  /// the joint's faces do.
  [[nodiscard]] double slip_since(const ContactPoint& was) const;
  /// New contacts (`inherited` is 0) continue with the slip of their joint: that of the nearest contact that has
  /// slipped, or of one that has separated, as in `parting`.
  void hand_on(const std::vector<ContactPoint>& parting, std::vector<ContactPoint>& found,
               const std::vector<char>& inherited);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(opened_at_pairs_, parted_);
  }

 private:
  const JointLaws& laws_;
  const CurrentOutlines& outlines_;
  bool any_;                                                      ///< does any joint dilate?
  std::vector<std::pair<std::pair<int, int>, double>> openings_;  ///< of pairs, at which their faces still touch [m]
  std::vector<double> opened_;                                    ///< the largest of each block
  std::vector<double> opened_at_pairs_;
  std::vector<ContactPoint> parted_;  ///< contacts out of reach: what their joints remember
};

}  // namespace blockweir::solid
