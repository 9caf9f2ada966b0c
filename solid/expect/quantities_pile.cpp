// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the pile that a fall leaves: the blocks that can move and touch each other, without those thrown aside.

#include <algorithm>
#include <numeric>

#include "solid/expect/quantity_tables.hpp"

namespace blockweir::solid::expect {
namespace {

/// A group number for each block: connected by touching, directly or through others. Ground and supported blocks have
/// groups of their own, since a whole model may rest on one ground.
std::vector<std::size_t> groups_that_touch(const Outcome& o) {
  const scene::Scene& s = o.solid.scene();
  std::vector<bool> free(s.blocks.size());
  for (std::size_t b = 0; b < free.size(); ++b) free[b] = !s.blocks[b].fixed;
  for (const scene::Support& support : s.supports) free[static_cast<std::size_t>(support.block)] = false;
  for (const scene::ViscousFace& face : s.viscous_faces) free[static_cast<std::size_t>(face.block)] = false;
  std::vector<std::size_t> next(free.size());
  std::iota(next.begin(), next.end(), 0);
  const auto group = [&](std::size_t b) {
    while (next[b] != b) b = next[b] = next[next[b]];
    return b;
  };
  for (const ContactRow& c : o.last.contacts) {
    const auto a = static_cast<std::size_t>(c.vertex_block);
    const auto b = static_cast<std::size_t>(c.edge_block);
    if (c.state != 0 && free[a] && free[b]) next[group(a)] = group(b);
  }
  for (std::size_t b = 0; b < next.size(); ++b) next[b] = free[b] ? group(b) : next.size();
  return next;
}

/// Along axis 0 (x) or 1 (y), of the group with the most blocks.
template <int Axis>
double extent(const Outcome& o, const std::string& /*subject*/) {
  const std::vector<std::size_t> groups = groups_that_touch(o);
  std::vector<int> blocks(groups.size() + 1);
  for (const std::size_t g : groups) ++blocks[g];
  blocks.back() = 0;  // what is in no pile
  const auto largest = static_cast<std::size_t>(std::max_element(blocks.begin(), blocks.end()) - blocks.begin());
  if (blocks[largest] < 2) throw NoFigure("no pile: no two blocks that can move touch each other");
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t b = 0; b < groups.size(); ++b) {
    if (groups[b] != largest) continue;
    for (const Point& p : o.last.blocks[b].vertices_m) low = std::min(low, p[Axis]), high = std::max(high, p[Axis]);
  }
  return high - low;
}

}  // namespace

const Quantities& pile_quantities() {
  static const Quantities all = {{"pile_width_m", extent<0>}, {"pile_height_m", extent<1>}};
  return all;
}

}  // namespace blockweir::solid::expect
