// SPDX-License-Identifier: GPL-3.0-or-later
// Joints that dilate: their faces touch at a distance, and what they have slipped belongs to the joint. It is kept
// while the joint is open, handed to all contacts that the joint gets, and found again where blocks part and meet anew.
#include <algorithm>
#include <utility>

#include "bridge/scene/at.hpp"
#include "solid/contact/outline.hpp"
#include "solid/contact/search.hpp"

namespace blockweir::solid {

/// Slip of a contact that was closed last at its anchor: while it is open it goes on with the blocks, as the teeth of
/// the joint's faces do.
double ContactSearch::slip_since(const ContactPoint& was) const {
  const auto [from, to] = edge_of(was);
  const double length = (to - from).norm();
  return was.slip_m + (to - from).dot(vertex_of(was) - from) / length - was.anchor * length;
}

/// How far apart the faces of joints still touch.
void ContactSearch::note_openings(const std::vector<ContactPoint>& contacts) {
  openings_.clear();
  opened_.assign(opened_.size(), 0);
  const auto note = [this](const ContactPoint& c, double slip_m) {
    const double opening_m = laws_[c.law].dilation_m(slip_m);
    if (opening_m == 0) return;
    openings_.emplace_back(c.pair(), opening_m);
    for (const int b : {c.vertex_block, c.edge_block}) opened_[at(b)] = std::max(opened_[at(b)], opening_m);
  };
  for (const ContactPoint& c : contacts) note(c, c.slip_m);
  for (const ContactPoint& c : parted_) note(c, slip_since(c));
  std::sort(openings_.begin(), openings_.end());
}

/// The largest of a pair's contacts [m].
double ContactSearch::opening(int block_a, int block_b) const {
  if (openings_.empty()) return 0;
  const std::pair<int, int> pair = std::minmax(block_a, block_b);
  const auto next_pair = std::upper_bound(openings_.begin(), openings_.end(), pair,
                                          [](const auto& p, const auto& entry) { return p < entry.first; });
  if (next_pair == openings_.begin() || std::prev(next_pair)->first != pair) return 0;
  return std::prev(next_pair)->second;
}

/// Contacts that are new go on with the slip of their joint: of the nearest that has slipped, or of what has parted.
void ContactSearch::remember_slips(const std::vector<ContactPoint>& parting) {
  for (const ContactPoint& c : parting) {
    std::erase_if(parted_, [&](const ContactPoint& p) { return p.same_key(c); });
    parted_.push_back(c);
  }
  for (std::size_t i = 0; i < found_.size(); ++i) {
    ContactPoint& heir = found_[i];
    if (inherited_[i] != 0 || laws_[heir.law].dilation == 0) continue;
    const ContactPoint* nearest = nullptr;
    double least = 0;
    const auto look = [&](const ContactPoint& c) {
      if (!slips_on(c) || !of_one_joint(c, heir)) return;
      const double distance = c.same_key(heir) ? 0 : (vertex_of(c) - vertex_of(heir)).norm();
      if (nearest != nullptr && distance >= least) return;
      nearest = &c;
      least = distance;
    };
    for (std::size_t j = i; j-- > 0 && found_[j].pair() == heir.pair();) {
      if (inherited_[j] != 0) look(found_[j]);
    }
    for (std::size_t j = i + 1; j < found_.size() && found_[j].pair() == heir.pair(); ++j) {
      if (inherited_[j] != 0) look(found_[j]);
    }
    const ContactPoint* closed = nearest;
    for (const ContactPoint& c : parted_) look(c);
    if (nearest == nullptr) continue;
    heir.slip_m = nearest == closed ? nearest->slip_m : slip_since(*nearest);
    heir.slip_path_m = nearest->slip_path_m;
  }
  std::erase_if(parted_, [&](const ContactPoint& p) {
    return std::any_of(found_.begin(), found_.end(), [&](const ContactPoint& c) { return c.same_key(p); });
  });
}

}  // namespace blockweir::solid
