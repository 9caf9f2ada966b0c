// SPDX-License-Identifier: GPL-3.0-or-later
// What holds the blocks of an island.
#pragma once

#include <span>
#include <vector>

#include "solid/contact/contact_point.hpp"
#include "solid/contact/support.hpp"

namespace blockweir::solid {

/// The contacts and supports of an island: their indices, and all of them.
struct Held {
  std::span<const int> contact_ids;
  std::vector<ContactPoint>& contacts;
  std::span<const int> support_ids;
  std::vector<Support>& supports;
};

}  // namespace blockweir::solid
