// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/joint_sums.hpp"

#include "bridge/scene/at.hpp"
#include "bridge/scene/cracks.hpp"
#include "bridge/statics/loads.hpp"

namespace blockweir::solid {
namespace {

scene::Scene with_bolts_as_they_pull(scene::Scene scene, const std::vector<Bolt>& bolts) {
  for (std::size_t i = 0; i < bolts.size(); ++i) scene.bolts[i].prestress_n_per_m = bolts[i].acting.tension_n_per_m;
  return scene;
}

}  // namespace

std::vector<ForceSum> force_sums(const Solid& solid, const wire::Load& water, const std::vector<WaterPart>& parts,
                                 const std::set<std::pair<int, int>>& joints, const Point& about) {
  const scene::Scene& scene = solid.scene();
  const std::vector<int> above = scene::parted_by(scene, joints);
  const std::vector<Point> centroids = statics::centroids_of(scene);
  std::vector<ForceSum> sums;
  const auto add = [&](const std::string& name, const statics::Wrenches& wrenches) {
    ForceSum sum{.name = name, .force = Point::Zero()};
    for (const int b : above) {
      const statics::Wrench& w = wrenches[at(b)];
      sum.force += w.head<2>();
      sum.moment_n += w[2] + geometry::cross(centroids[at(b)] - about, w.head<2>());
    }
    if (!sum.force.isZero(0) || sum.moment_n != 0) sums.push_back(std::move(sum));
  };
  add("weight", statics::weights_of(scene));
  for (const auto& [name, loads] : statics::stated_loads_by_name(scene, scene.analysis.duration_s)) add(name, loads);
  add("bolts", statics::prestress_of(with_bolts_as_they_pull(scene, solid.bolts())));
  statics::Wrenches at_rest = statics::water_forces(scene, water, 0, water.cracks_from);
  for (const WaterPart& part : parts) at_rest = statics::combined(std::move(at_rest), -1, part.wrenches);
  add("open water", at_rest);
  for (const WaterPart& part : parts) add(part.name, part.wrenches);
  add("water in joints", statics::water_forces(scene, water, water.cracks_from, water.block.size()));
  return sums;
}

}  // namespace blockweir::solid
