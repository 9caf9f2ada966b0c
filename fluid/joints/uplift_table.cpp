// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/uplift_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "bridge/scene/at.hpp"
#include "bridge/scene/hydrostatics.hpp"

namespace blockweir::joints {
namespace {

/// A joint's ends so far; the mouth is the upstream one.
struct Reach {
  std::size_t number = 0;
  Point mouth;
  Point end;
  int drain = -1;
  Point drain_at = Point::Zero();
};

/// The mouth of an upright joint is its lower end.
void extend(Reach& reach, const Point& p) {
  constexpr double upright = 1e-6;
  const auto along = [](const Point& q) { return q.x() + upright * q.y(); };
  if (along(p) < along(reach.mouth)) reach.mouth = p;
  if (along(p) > along(reach.end)) reach.end = p;
}

/// Of still water in the pool of that level; NaN: there is none.
End end_at(const scene::Scene& scene, double level_m, const Point& p) {
  return {std::isnan(level_m) ? 0 : scene::in_joints(scene, level_m).pressure(p.y()), p.y()};
}

void add_laws(const scene::Scene& scene, const FlowInJoints& flow, const Reach& reach, JointUplift& into) {
  const Joint joint{.mouth = end_at(scene, flow.upstream_level_m(), reach.mouth),
                    .end = end_at(scene, flow.downstream_level_m(), reach.end),
                    .length_m = into.length_m,
                    .water_n_per_m3 = scene::unit_weight_of_water(scene)};
  into.triangular_n_per_m = uplift(scene::Uplift::triangular, {}, joint).force();
  into.full_n_per_m = uplift(scene::Uplift::full, {}, joint).force();
  const double span_m = (reach.end - reach.mouth).norm();
  if (reach.drain < 0 || span_m == 0) return;
  const scene::DrainLine& line = scene.joint_flow.drains[at(reach.drain)];
  scene::KnownHeads known;
  known.drain = scene::Drain{.station_m = into.length_m * (reach.drain_at - reach.mouth).norm() / span_m,
                             .efficiency = line.efficiency,
                             .head_m = line.head_m.value_or(reach.drain_at.y())};
  into.drained_n_per_m = uplift(scene::Uplift::drained, known, joint).force();
}

}  // namespace

std::vector<JointUplift> joint_uplifts(const scene::Scene& scene, const FlowInJoints& flow) {
  std::vector<JointUplift> joints;
  std::map<std::pair<int, int>, Reach> reaches;
  const JointNetwork& network = flow.joints();
  for (std::size_t c = 0; c < network.parts().size(); ++c) {
    const Part& part = network.parts()[c];
    const Stretch& stretch = network.stretches()[part.stretch];
    const Channel& channel = network.network().channels[c];
    const Point from = stretch.place(part.from);
    const auto [found, is_new] = reaches.try_emplace(std::minmax(stretch.sides[0].block, stretch.sides[1].block),
                                                     Reach{joints.size(), from, from});
    Reach& reach = found->second;
    if (is_new) joints.push_back({.name = network.name(stretch)});
    extend(reach, from);
    extend(reach, stretch.place(part.to));
    for (const int node : {channel.from, channel.to}) {
      const Place& place = network.places()[at(node)];
      if (place.drain >= 0) reach.drain = place.drain, reach.drain_at = place.at;
    }
    JointUplift& joint = joints[reach.number];
    joint.length_m += channel.length_m;
    joint.uplift_n_per_m += flow.profile(c).force();
    if (!part.open) joint.flow_m2_per_s = std::max(joint.flow_m2_per_s, std::abs(flow.filling().flow[c]));
  }
  for (const auto& [blocks, reach] : reaches) {
    JointUplift& joint = joints[reach.number];
    joint.reynolds = joint.flow_m2_per_s * scene.water.density_kg_per_m3 / scene.joint_flow.viscosity_pa_s;
    add_laws(scene, flow, reach, joint);
  }
  return joints;
}

}  // namespace blockweir::joints
