// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/flat_joints.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "bridge/geometry/point.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

struct Touched {
  std::pair<int, int> parts;  // what is frozen counts as one
  int contact = 0;
  Point place;
};

using Joint = std::vector<Touched>::const_iterator;

Joint farthest_from(const Point& place, Joint first, Joint end) {
  return std::max_element(first, end, [&](const Touched& a, const Touched& b) {
    return (a.place - place).squaredNorm() < (b.place - place).squaredNorm();
  });
}

void add_inside(Joint first, Joint end, double round_off_m, std::vector<int>& inside) {
  constexpr double flat = 2e-3;  // of its length: sweeps close what stands off by more
  if (end - first < 3) return;
  const Joint from = farthest_from(first->place, first, end);
  const Joint to = farthest_from(from->place, first, end);
  const Point chord = to->place - from->place;
  double off_m = 0;
  for (Joint t = first; t != end; ++t)
    off_m = std::max(off_m, std::abs(geometry::cross(chord, t->place - from->place)) / chord.norm());
  if (!(off_m > 4 * round_off_m && off_m <= flat * chord.norm())) return;
  for (Joint t = first; t != end; ++t) {
    if (t != from && t != to) inside.push_back(t->contact);
  }
}

}  // namespace

std::vector<int> inside_flat_joints(const Trial& trial, const std::vector<bool>& frozen, double round_off_m,
                                    const IslandContacts& island) {
  std::vector<Touched> touched;
  const auto part = [&](int b) { return frozen[at(b)] ? -1 : b; };
  for (const int k : island.contact_ids) {
    const ContactPoint& c = island.contacts[at(k)];
    if (c.state == ContactState::open) continue;
    touched.push_back({std::minmax({part(c.vertex_part), part(c.edge_part)}), k,
                       trial.placement[at(c.vertex_part)].position(c.vertex_at)});
  }
  std::stable_sort(touched.begin(), touched.end(), [](const auto& a, const auto& b) { return a.parts < b.parts; });
  std::vector<int> inside;
  for (auto first = touched.cbegin(), end = first; first != touched.cend(); first = end) {
    while (end != touched.cend() && end->parts == first->parts) ++end;
    add_inside(first, end, round_off_m, inside);
  }
  return inside;
}

}  // namespace blockweir::solid
