// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/memory_before.hpp"

#include <algorithm>

#include "solid/block/parallel.hpp"

namespace blockweir::solid {

void MemoryBefore::make_room(std::size_t contacts, std::size_t supports) {
  contacts_.resize(contacts);
  supports_.resize(supports);
}

bool MemoryBefore::differs(const Held& held) const {
  return std::any_of(held.contact_ids.begin(), held.contact_ids.end(), [&](int k) {
    const ContactMemory& before = contacts_[at(k)];
    const ContactMemory& now = held.contacts[at(k)];
    return now.state != before.state || (now.state == ContactState::slip && now.force.y() * before.force.y() < 0);
  });
}

void MemoryBefore::restore(const Held& held) const {
  for_each(held.contact_ids.size(), [&](std::size_t i) {
    const auto k = at(held.contact_ids[i]);
    static_cast<ContactMemory&>(held.contacts[k]) = contacts_[k];
  });
  for (const int k : held.support_ids) held.supports[at(k)] = supports_[at(k)];
}

}  // namespace blockweir::solid
