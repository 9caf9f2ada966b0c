// SPDX-License-Identifier: GPL-3.0-or-later
// What blocks that push the same water do to each other, as the last two columns of a Load: where there are no such
// pairs they are left out. C++17.
#pragma once

#include "bridge/wire/column_codec.hpp"
#include "bridge/wire/message.hpp"

namespace blockweir::wire {

inline void write_pairs(ColumnWriter& write, const Load& m) {
  if (m.coupled.empty()) return;
  write(m.coupled);
  write(m.added_mass_between);
}

/// Throws BadMessage where there is not one mass a pair, or one that is not finite.
inline void read_pairs(ColumnReader& columns, Load& m) {
  m.coupled.clear();
  m.added_mass_between.clear();
  if (!columns.more()) return;
  columns.read<Any>(m.coupled, "coupled");
  if (!columns.read<Finite>(m.added_mass_between, "added_mass_between")) {
    throw BadMessage(fmt::format("an added mass between blocks that is not finite in window {}", m.window));
  }
  if (m.coupled.size() == m.added_mass_between.size()) return;
  throw BadMessage(fmt::format("{} pairs of blocks and {} added masses between them in window {}", m.coupled.size(),
                               m.added_mass_between.size(), m.window));
}

}  // namespace blockweir::wire
