// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/slips_since_rest.hpp"

#include <algorithm>

#include "bridge/scene/at.hpp"
#include "solid/watch/moving_body.hpp"

namespace blockweir::solid {

std::vector<double> SlipsSinceRest::largest() const {
  std::vector<double> found(at_.size());
  const MovedSince moved(solid_, at_, s_);
  for (const ContactPoint& c : solid_.contacts()) {
    if (c.state == ContactState::open && !c.has_touched()) continue;
    const double apart_m = moved.apart(c).norm();
    for (const int block : {c.vertex_block, c.edge_block}) found[at(block)] = std::max(found[at(block)], apart_m);
  }
  return found;
}

}  // namespace blockweir::solid
