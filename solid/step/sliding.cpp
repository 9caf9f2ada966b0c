// SPDX-License-Identifier: GPL-3.0-or-later
// Which blocks slide: their strains are damped where the material does not say how.
#include "bridge/scene/at.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Of a block with a mesh all triangles. Matrices are made anew where another block slides.
void Solid::find_sliding_blocks() {
  if (contacts_stand_ && !slides_.empty()) return;
  std::vector<bool> slides(blocks_.size());
  for (const ContactPoint& c : contacts_) {
    if (c.state != ContactState::slip) continue;
    for (const int block : {c.vertex_block, c.edge_block}) {
      slides[at(block)] = true;
      for (const int t : parts_.triangles[at(block)]) slides[at(t)] = true;
    }
  }
  if (slides == slides_) return;
  slides_.swap(slides);
  matrices_dt_ = -1;
}

}  // namespace blockweir::solid
