// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/new_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "bridge/scene/at.hpp"

namespace blockweir::solid::output {
namespace {

std::pair<int, int> pair_of(const ContactRow& c) {
  return std::minmax(c.vertex_block, c.edge_block);
}

/// A joint of one of the two blocks whose residual friction is not that of [joint]; null where there is none.
const scene::Joint* other_joint(const scene::Scene& scene, const std::pair<int, int>& pair) {
  const auto found = std::find_if(scene.joints.begin(), scene.joints.end(), [&](const scene::Joint& joint) {
    const auto& [a, b] = joint.between;
    const bool of_pair = a == pair.first || a == pair.second || b == pair.first || b == pair.second;
    return of_pair && joint.law.residual_friction_angle_deg != scene.default_joint.residual_friction_angle_deg;
  });
  return found == scene.joints.end() ? nullptr : &*found;
}

}  // namespace

std::string new_contacts_warning(const expect::Outcome& o) {
  const scene::Scene& scene = o.solid.scene();
  std::set<std::pair<int, int>> known;
  for (const ContactRow& c : o.first.contacts) known.insert(pair_of(c));
  std::set<std::pair<int, int>> met;
  for (const ContactPoint& c : o.solid.contacts()) {
    constexpr int default_law = 0;  // not that of a cut, along whose edge a block slides
    if (c.state == ContactState::open || c.law != default_law || known.contains(c.pair())) continue;
    if (other_joint(scene, c.pair()) != nullptr) met.insert(c.pair());
  }
  if (met.empty()) return {};
  const std::pair<int, int> first = *met.begin();
  const scene::Joint& joint = *other_joint(scene, first);
  return fmt::format(
      "blocks \"{}\" and \"{}\"{} touch now and did not at the start: between them [joint] holds, friction {:.4g} deg, "
      "not joint \"{}\" with {:.4g} deg; name such pairs in [[joints]] where they slide along the same joint",
      scene.blocks[at(first.first)].name, scene.blocks[at(first.second)].name,
      met.size() > 1 ? fmt::format(", and {} more pairs,", met.size() - 1) : "",
      scene.default_joint.residual_friction_angle_deg, joint.set.empty() ? joint.name : joint.set,
      joint.law.residual_friction_angle_deg);
}

}  // namespace blockweir::solid::output
