// SPDX-License-Identifier: GPL-3.0-or-later
// The memory of contacts and supports at the start of the step.
#pragma once

#include <vector>

#include "bridge/scene/at.hpp"
#include "solid/contact/island_contacts.hpp"

namespace blockweir::solid {

class MemoryBefore {
 public:
  void make_room(std::size_t contacts, std::size_t supports);
  void note(int index, const ContactPoint& c) { contacts_[at(index)] = c; }
  void note(int index, const Support& s) { supports_[at(index)] = s; }

  [[nodiscard]] const ContactMemory& contact(int index) const { return contacts_[at(index)]; }
  [[nodiscard]] const Support& support(int index) const { return supports_[at(index)]; }
  /// Has any contact closed, opened, begun or ceased to slip, or turned its slip round since?
  [[nodiscard]] bool differs(const IslandContacts& island) const;
  void restore(const IslandContacts& island) const;

 private:
  std::vector<ContactMemory> contacts_;
  std::vector<Support> supports_;
};

}  // namespace blockweir::solid
