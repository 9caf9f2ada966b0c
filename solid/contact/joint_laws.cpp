// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/contact/joint_laws.hpp"

#include <cmath>
#include <numbers>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/tension_cut_off.hpp"

namespace blockweir::solid {
namespace {

JointProperties properties(const scene::JointLaw& law, int joint) {
  const auto tangent = [](double degrees) { return std::tan(degrees * std::numbers::pi / 180); };
  return {.friction = tangent(law.friction_angle_deg),
          .residual_friction = tangent(law.residual_friction_angle_deg),
          .cohesion_pa = law.cohesion_pa,
          .tension_pa = scene::tension_cut_off_pa(law),
          .bonded_length_m = law.bonded_length_m.value_or(-1),
          .keeps_cohesion = law.keeps_cohesion,
          .softening_slip_m = law.softening_slip_m,
          .dilation = tangent(law.dilation_angle_deg),
          .dilation_limit_m = law.dilation_limit_m.value_or(std::numeric_limits<double>::infinity()),
          .joint = joint};
}

}  // namespace

JointLaws::JointLaws(const scene::Scene& scene) {
  laws_.push_back(properties(scene.default_joint, -1));
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const auto& joint = scene.joints[j];
    by_pair_[key(joint.between[0], joint.between[1])] = static_cast<int>(laws_.size());
    laws_.push_back(properties(joint.law, static_cast<int>(j)));
  }
  add_cuts(scene);
}

/// A block that comes onto the edge of a cut later was not bonded to it, and is none of the cut's joints.
void JointLaws::add_cuts(const scene::Scene& scene) {
  touching_m_ = scene::rounding_ratio * scene::structure_size_m(scene.blocks);
  std::vector<std::pair<const scene::Joint*, int>> cuts;
  for (const scene::Joint& joint : scene.joints) {
    if (joint.set.empty()) continue;
    auto cut = std::find_if(cuts.begin(), cuts.end(), [&](const auto& known) {
      return known.first->set == joint.set && known.first->law == joint.law;
    });
    if (cut == cuts.end()) {
      cut = cuts.insert(cut, {&joint, static_cast<int>(laws_.size())});
      JointProperties law = properties(joint.law, -1);
      law.friction = law.residual_friction;
      law.cohesion_pa = law.tension_pa = 0;
      law.bonded_length_m = -1;
      laws_.push_back(law);
    }
    const auto [a, b] = joint.between;
    for (const scene::TracePiece& p :
         scene::trace_joint(scene.blocks[at(a)], scene.blocks[at(b)], touching_m_).pieces) {
      for (const int block : {a, b}) cut_edges_[block].push_back({p.from_m, p.to_m, cut->second});
    }
  }
}

int JointLaws::of_cut(int block, const geometry::Point& middle) const {
  const auto edges = cut_edges_.find(block);
  if (edges == cut_edges_.end()) return 0;
  const auto nearest =
      std::min_element(edges->second.begin(), edges->second.end(), [&](const CutEdge& a, const CutEdge& b) {
        return geometry::distance_to_segment(middle, a.from_m, a.to_m) <
               geometry::distance_to_segment(middle, b.from_m, b.to_m);
      });
  return geometry::distance_to_segment(middle, nearest->from_m, nearest->to_m) <= touching_m_ ? nearest->law : 0;
}

}  // namespace blockweir::solid
