// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/joint_openings.hpp"

#include <algorithm>

namespace blockweir::solid {

JointOpenings::JointOpenings(const JointLaws& laws, const CurrentOutlines& outlines)
    : laws_(laws),
      outlines_(outlines),
      any_(laws.dilate()),
      opened_(outlines.all().size(), 0.0),
      opened_at_pairs_(opened_) {}

double JointOpenings::slip_since(const ContactPoint& was) const {
  const auto [from, to] = outlines_.edge_of(was);
  const double length = (to - from).norm();
  return was.slip_m + (to - from).dot(outlines_.vertex_of(was) - from) / length - was.anchor * length;
}

void JointOpenings::note(const std::vector<ContactPoint>& contacts) {
  if (!any_) return;
  openings_.clear();
  opened_.assign(opened_.size(), 0);
  const auto add = [this](const ContactPoint& c, double slip_m) {
    const double opening_m = laws_[c.law].dilation_m(slip_m);
    if (opening_m == 0) return;
    openings_.emplace_back(c.pair(), opening_m);
    for (const int b : {c.vertex_block, c.edge_block}) opened_[at(b)] = std::max(opened_[at(b)], opening_m);
  };
  for (const ContactPoint& c : contacts) add(c, c.slip_m);
  for (const ContactPoint& c : parted_) add(c, slip_since(c));
  std::sort(openings_.begin(), openings_.end());
}

double JointOpenings::between(int block_a, int block_b) const {
  if (openings_.empty()) return 0;
  const std::pair<int, int> pair = std::minmax(block_a, block_b);
  const auto next_pair = std::upper_bound(openings_.begin(), openings_.end(), pair,
                                          [](const auto& p, const auto& entry) { return p < entry.first; });
  if (next_pair == openings_.begin() || std::prev(next_pair)->first != pair) return 0;
  return std::prev(next_pair)->second;
}

void JointOpenings::hand_on(const std::vector<ContactPoint>& parting, std::vector<ContactPoint>& found,
                            const std::vector<char>& inherited) {
  if (!any_) return;
  for (const ContactPoint& c : parting) {
    std::erase_if(parted_, [&](const ContactPoint& p) { return p.same_key(c); });
    parted_.push_back(c);
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    ContactPoint& heir = found[i];
    if (inherited[i] != 0 || laws_[heir.law].dilation == 0) continue;
    const ContactPoint* nearest = nullptr;
    double least = 0;
    const auto look = [&](const ContactPoint& c) {
      if (!slips_on(c) || !outlines_.of_one_joint(c, heir)) return;
      const double distance = c.same_key(heir) ? 0 : (outlines_.vertex_of(c) - outlines_.vertex_of(heir)).norm();
      if (nearest != nullptr && distance >= least) return;
      nearest = &c;
      least = distance;
    };
    for (std::size_t j = i; j-- > 0 && found[j].pair() == heir.pair();) {
      if (inherited[j] != 0) look(found[j]);
    }
    for (std::size_t j = i + 1; j < found.size() && found[j].pair() == heir.pair(); ++j) {
      if (inherited[j] != 0) look(found[j]);
    }
    const ContactPoint* closed = nearest;
    for (const ContactPoint& c : parted_) look(c);
    if (nearest == nullptr) continue;
    heir.slip_m = nearest == closed ? nearest->slip_m : slip_since(*nearest);
    heir.slip_path_m = nearest->slip_path_m;
  }
  std::erase_if(parted_, [&](const ContactPoint& p) {
    return std::any_of(found.begin(), found.end(), [&](const ContactPoint& c) { return c.same_key(p); });
  });
}

}  // namespace blockweir::solid
