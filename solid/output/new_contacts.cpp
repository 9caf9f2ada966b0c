// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/new_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "bridge/geometry/outline.hpp"
#include "bridge/results/counted.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::solid::output {
namespace {

std::pair<int, int> pair_of(const ContactRow& c) {
  return std::minmax(c.vertex_block, c.edge_block);
}

/// Do the outlines meet as drawn, be it in a point?
bool touch_as_drawn(const scene::Scene& scene, const std::pair<int, int>& pair) {
  const double touching_m = scene::rounding_ratio * scene::structure_size_m(scene.blocks);
  const auto reaches = [&](const scene::Block& a, const scene::Block& b) {
    return std::any_of(a.vertices.begin(), a.vertices.end(), [&](const Point& vertex) {
      for (std::size_t i = 0, n = b.vertices.size(); i < n; ++i) {
        if (geometry::distance_to_segment(vertex, b.vertices[i], b.vertices[(i + 1) % n]) <= touching_m) return true;
      }
      return false;
    });
  };
  const scene::Block& a = scene.blocks[at(pair.first)];
  const scene::Block& b = scene.blocks[at(pair.second)];
  return reaches(a, b) || reaches(b, a);
}

/// As corners of four blocks at a crossing of joints do, from the start.
bool still_meet_in_a_point(const Solid& solid, const std::pair<int, int>& pair) {
  constexpr double near = 1e-3;  // of the structure's size: next to no length
  const auto has_length = [&](const ContactPoint& c) {
    return c.pair() == pair && c.length > near * solid.model().size_m;
  };
  return std::none_of(solid.contacts().begin(), solid.contacts().end(), has_length) &&
         touch_as_drawn(solid.scene(), pair);
}

/// A joint of one of the two blocks with residual friction of that angle, or of another; null where there is none.
const scene::Joint* joint_with(const scene::Scene& scene, const std::pair<int, int>& pair, double angle_deg,
                               bool of_that) {
  const auto found = std::find_if(scene.joints.begin(), scene.joints.end(), [&](const scene::Joint& joint) {
    const auto& [a, b] = joint.between;
    const bool of_pair = a == pair.first || a == pair.second || b == pair.first || b == pair.second;
    return of_pair && (std::abs(joint.law.residual_friction_angle_deg - angle_deg) < 1e-9) == of_that;
  });
  return found == scene.joints.end() ? nullptr : &*found;
}

const scene::Joint* other_joint(const scene::Scene& scene, const std::pair<int, int>& pair) {
  return joint_with(scene, pair, scene.default_joint.residual_friction_angle_deg, false);
}

std::string named(const scene::Scene& scene, const std::set<std::pair<int, int>>& met) {
  const auto& [a, b] = *met.begin();
  return fmt::format("blocks \"{}\" and \"{}\"{} touch now and did not at the start", scene.blocks[at(a)].name,
                     scene.blocks[at(b)].name,
                     met.size() > 1 ? fmt::format(", and {},", results::counted(met.size() - 1, "more pair")) : "");
}

/// Of blocks that have slid along the plane of a joint that the scene states for other blocks.
std::string of_planes(const expect::Outcome& o, const std::set<std::pair<int, int>>& known) {
  const scene::Scene& scene = o.solid.scene();
  std::set<std::pair<int, int>> met;
  const scene::Joint* plane = nullptr;
  for (const ContactPoint& c : o.solid.contacts()) {
    const JointProperties& law = o.solid.laws()[c.law];
    if (c.state == ContactState::open || c.law == 0 || law.joint >= 0 || known.contains(c.pair())) continue;
    const double angle_deg = std::atan(law.friction) * 180 / std::numbers::pi;
    const scene::Joint* joint = joint_with(scene, c.pair(), angle_deg, true);
    if (joint == nullptr || !joint->set.empty()) continue;  // of a cut, that is what it is for
    if (std::abs(angle_deg - scene.default_joint.residual_friction_angle_deg) < 1e-9) continue;
    if (still_meet_in_a_point(o.solid, c.pair())) continue;
    if (met.insert(c.pair()).second && *met.begin() == c.pair()) plane = joint;
  }
  if (plane == nullptr) return {};
  return fmt::format(
      "{}: they slid along the plane of joint \"{}\" and have its residual friction of {:.4g} deg; [joint] has {:.4g} "
      "deg; if that is not meant, state a law for each such pair in [[joints]]",
      named(scene, met), plane->name, plane->law.residual_friction_angle_deg,
      scene.default_joint.residual_friction_angle_deg);
}

}  // namespace

std::string new_contacts_warning(const expect::Outcome& o) {
  const scene::Scene& scene = o.solid.scene();
  std::set<std::pair<int, int>> known;
  for (const ContactRow& c : o.first.contacts) known.insert(pair_of(c));
  std::set<std::pair<int, int>> met;
  for (const ContactPoint& c : o.solid.contacts()) {
    constexpr int default_law = 0;  // not the law of a cut along whose edge a block slides
    if (c.state == ContactState::open || c.law != default_law || known.contains(c.pair())) continue;
    if (other_joint(scene, c.pair()) != nullptr) met.insert(c.pair());
  }
  std::erase_if(met, [&](const auto& pair) { return still_meet_in_a_point(o.solid, pair); });
  if (met.empty()) return of_planes(o, known);
  const scene::Joint& joint = *other_joint(scene, *met.begin());
  return fmt::format(
      "{}: between them [joint] holds, friction {:.4g} deg, not joint \"{}\" with {:.4g} deg; name such pairs in "
      "[[joints]] where they slide along the same joint",
      named(scene, met), scene.default_joint.residual_friction_angle_deg, joint.set.empty() ? joint.name : joint.set,
      joint.law.residual_friction_angle_deg);
}

}  // namespace blockweir::solid::output
