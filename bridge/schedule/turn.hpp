// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that both sides are at the same window.
#pragma once

#include <fmt/format.h>

#include "bridge/channel/channel.hpp"

namespace blockweir::schedule {

inline void require_turn(std::uint64_t got, std::uint64_t due, const std::string& sender) {
  if (got == due) return;
  throw channel::PartnerFault(
      fmt::format("{} sent window {} where window {} was due; start both sides anew", sender, got, due));
}

}  // namespace blockweir::schedule
