// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/expect/formula_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::solid::expect {

PlaneJoint plane_joint(const Scene& s, const std::string& name) {
  const scene::Joint& named = joint_named(s, name);
  if (named.law.bends()) {
    throw std::runtime_error(fmt::format(
        "joint \"{}\" has a friction that changes with the normal stress; expected one with a friction angle "
        "alone, as formulas have it; expect a value in place of a formula",
        name));
  }
  const auto higher_of = [&](const scene::Joint& joint) {
    const auto centre_height = [&](int block) { return geometry::centroid(s.blocks[at(block)].vertices).y(); };
    return joint.between[centre_height(joint.between[0]) > centre_height(joint.between[1]) ? 0 : 1];
  };
  const int upper = higher_of(named);
  PlaneJoint plane{.dip = std::numbers::pi / 2, .upper = &s.blocks[at(upper)]};
  plane.weight = weight(s, *plane.upper);
  plane.friction = named.law.friction();
  plane.law = &named.law;
  const double touching_m = 1e-6 * scene::structure_size_m(s.blocks);
  for (const scene::Joint& joint : s.joints) {
    if (higher_of(joint) != upper) continue;
    const auto trace = scene::trace_joint(s.blocks[at(joint.between[0])], s.blocks[at(joint.between[1])], touching_m);
    if (&joint == &named && trace.pieces.empty())
      throw std::runtime_error(
          fmt::format("the blocks of joint \"{}\" do not touch; expected an edge of one on the other; name a joint "
                      "that has a length",
                      name));
    if (&joint == &named) plane.mouth = trace.mouth();
    plane.length += trace.length_m;
    plane.cohesion += joint.law.cohesion_pa * joint.law.bonded_length_m.value_or(trace.length_m);
    for (const auto& piece : trace.pieces) {
      const Point d = piece.to_m - piece.from_m;
      plane.dip = std::min(plane.dip, std::atan2(-d.y(), d.x()));
    }
  }
  plane.dip += s.analysis.gravity_tilt_deg * std::numbers::pi / 180;
  return plane;
}

}  // namespace blockweir::solid::expect
