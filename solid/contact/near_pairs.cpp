// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/near_pairs.hpp"

#include <algorithm>
#include <atomic>

#include "solid/block/parallel.hpp"

namespace blockweir::solid {

NearPairs::NearPairs(double reach_m, double farthest_reach_m, std::size_t blocks)
    : reach_(std::min(reach_m, farthest_reach_m)), farthest_reach_(farthest_reach_m), boxes_(blocks) {}

bool NearPairs::covers(double moved_m) {
  if (reach_per_move * moved_m <= reach_ || reach_ == farthest_reach_) return true;
  reach_ = std::min(farthest_reach_, 2 * reach_per_move * moved_m);
  corners_at_pairs_.clear();
  return false;
}

void NearPairs::refresh(const std::vector<Placement>& placements, CurrentOutlines& outlines, JointOpenings& openings) {
  std::atomic<bool> stale = corners_at_pairs_.empty();
  for_each(boxes_.size(), [&](std::size_t b) {
    outlines.move(b, placements);
    const std::vector<Point>& corners = outlines.all()[b];
    boxes_[b].setEmpty();
    bool left = false;
    const double room = margin() / 2 - openings.since_pairs_m(b);
    for (std::size_t v = 0; v < corners.size(); ++v) {
      boxes_[b].extend(corners[v]);
      left =
          left || (!corners_at_pairs_.empty() && (corners[v] - corners_at_pairs_[b][v]).cwiseAbs().maxCoeff() > room);
    }
    boxes_[b].min().array() -= reach_ / 2 + openings.largest_m(b);
    boxes_[b].max().array() += reach_ / 2 + openings.largest_m(b);
    if (left) stale.store(true, std::memory_order_relaxed);
  });
  if (!stale) return;
  corners_at_pairs_ = outlines.all();
  openings.note_pairs();
  std::vector<Box> wide = boxes_;
  std::vector<bool> movable(boxes_.size());
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    wide[b].min().array() -= margin() / 2;
    wide[b].max().array() += margin() / 2;
    movable[b] = !outlines.parts().blocks[b].fixed;
  }
  pairs_ = neighbours(wide, movable);
  ++searches_;
}

}  // namespace blockweir::solid
