// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/bonds.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/block/parallel.hpp"
#include "solid/contact/common_slip.hpp"

namespace blockweir::solid {
namespace {

class Bonds {
 public:
  Bonds(const JointLaws& laws, double tolerance_n, const std::vector<Block>& blocks,
        std::vector<ContactPoint>& contacts)
      : laws_(laws), tolerance_n_(tolerance_n), blocks_(blocks), contacts_(contacts) {}

  [[nodiscard]] bool stays(int k) const {
    const ContactPoint& c = contacts_[at(k)];
    if (c.bond == 0) return true;
    return (c.state == ContactState::stick || laws_[c.law].keeps_cohesion) && overstress_pa(c) <= 0;
  }

  bool break_joint(std::span<const int> joint) const { return pull_off(joint) || lose(joint); }

 private:
  [[nodiscard]] bool breakable(const ContactPoint& c) const { return c.bond > 0 && !laws_[c.law].keeps_cohesion; }

  /// Tension beyond the strength of a bond that holds; 0 where there is none.
  [[nodiscard]] double overstress_pa(const ContactPoint& c) const {
    if (c.let_go) return 0;
    const Strength strength = laws_.strength(c, c.force.x());
    const double excess_n = -c.force.x() - strength.tension - tolerance_n_;
    return strength.holds_together() && excess_n > 0 ? excess_n / c.bond_length : 0;
  }

  [[nodiscard]] bool pull_off(std::span<const int> joint) const {
    constexpr double most = 0.5;  // of the largest overstress: contacts that are pulled alike break at once
    double worst = 0;
    for (const int k : joint) worst = std::max(worst, overstress_pa(contacts_[at(k)]));
    if (worst == 0) return false;
    for (const int k : joint) {
      ContactPoint& c = contacts_[at(k)];
      const double overstress = overstress_pa(c);
      const bool brittle = laws_[c.law].tension_pa > 0;
      if (overstress == 0 || (brittle && overstress < most * worst)) continue;
      c.let_go = true;
      if (brittle && breakable(c)) c.bond = 0;
    }
    return true;
  }

  [[nodiscard]] bool lose(std::span<const int> joint) const {
    double shear_n = 0;
    double strength_n = 0;
    for (const int k : joint) {
      const ContactPoint& c = contacts_[at(k)];
      if (c.state == ContactState::open) continue;
      shear_n += c.force.y();
      strength_n += laws_.strength(c, c.force.x()).shear_bound(c.force.x());
    }
    constexpr double round_off = 1e-6;
    // What slips in directions that no motion has in common only strains under its load.
    const bool held = std::abs(shear_n) < (1 - round_off) * strength_n || !slips_as_one(blocks_, contacts_, joint);
    const auto survives = [&](const ContactPoint& c) {
      if (c.state == ContactState::stick) return true;
      return c.state == ContactState::slip && (laws_[c.law].softens() || held);
    };
    bool broken = false;
    for (const int k : joint) {
      ContactPoint& c = contacts_[at(k)];
      if (!breakable(c) || survives(c)) continue;
      c.bond = 0;
      broken = true;
    }
    return broken;
  }

  const JointLaws& laws_;
  double tolerance_n_;
  const std::vector<Block>& blocks_;
  std::vector<ContactPoint>& contacts_;
};

}  // namespace

bool break_bonds(const JointLaws& laws, double tolerance_n, const std::vector<Block>& blocks,
                 std::span<const int> contact_ids, std::vector<ContactPoint>& contacts) {
  const Bonds bonds(laws, tolerance_n, blocks, contacts);
  if (all_of(contact_ids.size(), [&](std::size_t i) { return bonds.stays(contact_ids[i]); })) return false;
  bool broken = false;
  for (auto first = contact_ids.begin(), end = first; first != contact_ids.end(); first = end) {
    end = std::find_if(first, contact_ids.end(),
                       [&](int k) { return contacts[at(k)].pair() != contacts[at(*first)].pair(); });
    broken = bonds.break_joint({first, end}) || broken;
  }
  return broken;
}

}  // namespace blockweir::solid
