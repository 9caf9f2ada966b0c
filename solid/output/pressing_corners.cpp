// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/pressing_corners.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/scene/at.hpp"

namespace blockweir::solid::output {
namespace {

/// Is the vertex at an end of the contact's edge?
bool meets_corner(const Solid& solid, const ContactPoint& c, double near_m) {
  const Placement& edge = solid.placements()[at(c.edge_part)];
  const Point vertex = solid.state().place(c);
  return std::min((edge.position(c.edge_from) - vertex).norm(), (edge.position(c.edge_to) - vertex).norm()) <= near_m;
}

}  // namespace

std::string pressing_corners_warning(const expect::Outcome& o) {
  constexpr double near = 1e-3;   // of the structure's size: next to no length
  constexpr double least = 1e-3;  // of the weight
  const Solid& solid = o.solid;
  const bool moved = o.last.largest_displacement_m > solid.scene().analysis.failure_displacement_m;
  if (moved || !o.failure.failures().empty()) return {};  // stones that have come to rest lie on corners, too
  const double near_m = near * solid.model().size_m;
  const auto& contacts = solid.contacts();
  const ContactPoint* worst = nullptr;
  int count = 0;
  for (auto first = contacts.begin(), end = first; first != contacts.end(); first = end) {  // of a pair
    end = std::find_if(first, contacts.end(), [&](const ContactPoint& c) { return c.pair() != first->pair(); });
    const auto has_length = [&](const ContactPoint& c) { return c.length > near_m; };
    if (std::any_of(first, end, has_length)) continue;
    for (auto c = first; c != end; ++c) {
      const bool bears = c->state != ContactState::open && c->force.x() > least * solid.model().weight_n_per_m;
      if (!bears || !meets_corner(solid, *c, near_m)) continue;
      ++count;
      if (worst == nullptr || c->force.x() > worst->force.x()) worst = &*c;
    }
  }
  if (worst == nullptr) return {};
  const auto& blocks = solid.scene().blocks;
  return fmt::format(
      "corners of blocks \"{}\" and \"{}\", which only meet in a point, bear {:.3g} N per metre{}: real ones are "
      "crushed, "
      "and what stands here may fall without them; expected faces that bear; shift the joints so that no four blocks "
      "meet in a point, as by offset_m of a [[joint_set]], and compare \"blockweir level\", which counts no such force",
      blocks[at(worst->vertex_block)].name, blocks[at(worst->edge_block)].name, worst->force.x(),
      count > 1 ? fmt::format(", and {} more do", count - 1) : "");
}

}  // namespace blockweir::solid::output
