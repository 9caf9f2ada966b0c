// SPDX-License-Identifier: GPL-3.0-or-later
// Visits the parts of a large problem side by side.
#pragma once

#include "solid/block/parallel.hpp"
#include "solid/solve/parts.hpp"

namespace blockweir::solid {

/// visit(first, end, progress) for each part, side by side where there are several, and for what joins them: after the
/// parts or, on the way back, before them.
template <class Visit, class Progress>
void visit_parts(const EndsOfParts& ends, const Visit& visit, Progress& progress, bool back = false) {
  if (ends[0] == ends[sweep_parts]) return visit(std::size_t{0}, ends[0], progress);
  std::array<Progress, sweep_parts + 1> of_part{};
  if (back) visit(ends[sweep_parts - 1], ends[sweep_parts], of_part[sweep_parts]);
  share_by_place(sweep_parts,
                 [&](std::size_t part) { visit(part == 0 ? 0 : ends[part - 1], ends[part], of_part[part]); });
  if (!back) visit(ends[sweep_parts - 1], ends[sweep_parts], of_part[sweep_parts]);
  for (const Progress& of : of_part) progress += of;
}

}  // namespace blockweir::solid
