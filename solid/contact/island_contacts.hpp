// SPDX-License-Identifier: GPL-3.0-or-later
// The contacts and supports of an island, which hold its blocks.
#pragma once

#include <span>
#include <vector>

#include "solid/contact/contact_point.hpp"
#include "solid/contact/support.hpp"

namespace blockweir::solid {

/// Their indices, and the contacts and supports of all islands.
struct IslandContacts {
  std::span<const int> contact_ids;
  std::vector<ContactPoint>& contacts;
  std::span<const int> support_ids;
  std::vector<Support>& supports;
};

}  // namespace blockweir::solid
