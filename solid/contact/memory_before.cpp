// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/memory_before.hpp"

#include <algorithm>

#include "solid/block/parallel.hpp"

namespace blockweir::solid {

void MemoryBefore::make_room(std::size_t contacts, std::size_t supports) {
  contacts_.resize(contacts);
  supports_.resize(supports);
}

bool MemoryBefore::differs(const IslandContacts& island) const {
  return std::any_of(island.contact_ids.begin(), island.contact_ids.end(), [&](int k) {
    const ContactMemory& before = contacts_[at(k)];
    const ContactMemory& now = island.contacts[at(k)];
    return now.state != before.state || (now.state == ContactState::slip && now.force.y() * before.force.y() < 0);
  });
}

void MemoryBefore::restore(const IslandContacts& island) const {
  for_each(island.contact_ids.size(), [&](std::size_t i) {
    const auto k = at(island.contact_ids[i]);
    static_cast<ContactMemory&>(island.contacts[k]) = contacts_[k];
  });
  for (const int k : island.support_ids) island.supports[at(k)] = supports_[at(k)];
}

}  // namespace blockweir::solid
