// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/statics/loads.hpp"

#include <algorithm>
#include <limits>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/block_facts.hpp"
#include "bridge/scene/load_tables.hpp"

namespace blockweir::statics {
namespace {

/// Wrenches on blocks, force by force.
class Sum {
 public:
  explicit Sum(const scene::Scene& scene)
      : centroids_(centroids_of(scene)), sum_(scene.blocks.size(), Wrench::Zero()) {}

  void add(int block, const Point& force, const Point& place) {
    sum_[at(block)] += wrench_of(force, place, centroids_[at(block)]);
  }
  void add_at_centroid(std::size_t block, const Point& force) { sum_[block].head<2>() += force; }
  /// A force a metre that is linear from one point to the other: its consistent nodal forces L (2 q_i + q_j)/6.
  void add_line(int block, const Point& from, const Point& to, const Point& q_from, const Point& q_to) {
    const double length = (to - from).norm();
    add(block, length * (2 * q_from + q_to) / 6, from);
    add(block, length * (q_from + 2 * q_to) / 6, to);
  }
  /// Pressure on a part of an outline; `inward` is the unit normal into the block.
  void add_pressure(int block, const Point& from, const Point& to, const Point& inward, double p_from, double p_to) {
    add_line(block, from, to, p_from * inward, p_to * inward);
  }
  [[nodiscard]] const Wrenches& wrenches() const { return sum_; }

 private:
  std::vector<Point> centroids_;
  Wrenches sum_;
};

double mass_per_m(const scene::Scene& scene, const scene::Block& block) {
  return scene::material_of(scene, block).density_kg_per_m3 * geometry::signed_area(block.vertices);
}

Point left_of(const Point& along) {
  return Point(-along.y(), along.x()).normalized();
}

/// Does the part from..to of the block's outline run along it, counter-clockwise? Both lie on one edge.
bool runs_along(const scene::Block& block, const Point& from, const Point& to) {
  double nearest = std::numeric_limits<double>::infinity();
  bool along = true;
  for (std::size_t e = 0; e < block.vertices.size(); ++e) {
    const Point& a = block.vertices[e];
    const Point& b = block.vertices[(e + 1) % block.vertices.size()];
    const double distance = geometry::distance_to_segment(from, a, b) + geometry::distance_to_segment(to, a, b);
    if (distance >= nearest) continue;
    nearest = distance;
    along = (to - from).dot(b - a) > 0;
  }
  return along;
}

Wrenches inertia_of_shaking(const scene::Scene& scene, double time_s) {
  Sum sum(scene);
  if (!scene.base_motion) return sum.wrenches();
  const Point ground(scene.base_motion->acceleration_x_m_per_s2.at(time_s),
                     scene.base_motion->acceleration_y_m_per_s2.at(time_s));
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    sum.add_at_centroid(b, -mass_per_m(scene, scene.blocks[b]) * ground);
  }
  return sum.wrenches();
}

}  // namespace

std::vector<Point> centroids_of(const scene::Scene& scene) {
  std::vector<Point> centroids;
  for (const scene::Block& block : scene.blocks) centroids.push_back(geometry::centroid(block.vertices));
  return centroids;
}

Wrenches weights_of(const scene::Scene& scene) {
  Sum sum(scene);
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    sum.add_at_centroid(b, mass_per_m(scene, scene.blocks[b]) * scene.analysis.gravity());
  }
  return sum.wrenches();
}

std::vector<NamedWrenches> stated_loads_by_name(const scene::Scene& scene, double time_s) {
  const auto vector = [&](const std::array<scene::TimeTable, 2>& q) { return Point(q[0].at(time_s), q[1].at(time_s)); };
  Sum points(scene);
  for (const scene::PointLoad& load : scene.point_loads) {
    points.add(load.block, {load.force_x_n_per_m.at(time_s), load.force_y_n_per_m.at(time_s)}, load.point_m);
  }
  Sum pressures(scene);
  for (const scene::FacePressure& load : scene.face_pressures) {
    const bool along = runs_along(scene.blocks[at(load.block)], load.from_m, load.to_m);
    const Point left = left_of(load.to_m - load.from_m);
    pressures.add_pressure(load.block, load.from_m, load.to_m, along ? left : Point(-left),
                           load.pressure_from_pa.at(time_s), load.pressure_to_pa.at(time_s));
  }
  Sum lines(scene);
  Sum silt(scene);
  for (const scene::LineLoad& load : scene.line_loads) {
    Sum& sum = load.origin == scene::LoadOrigin::silt ? silt : lines;
    sum.add_line(load.block, load.from_m, load.to_m, vector(load.force_from_n_per_m2), vector(load.force_to_n_per_m2));
  }
  Sum bodies(scene);
  Sum earthquake(scene);
  for (const scene::BodyLoad& load : scene.body_loads) {
    for (const int b : load.blocks) {
      const scene::Block& block = scene.blocks[at(b)];
      const double per = load.per_mass ? mass_per_m(scene, block) : geometry::signed_area(block.vertices);
      (load.origin == scene::LoadOrigin::earthquake ? earthquake : bodies)
          .add_at_centroid(at(b), per * vector(load.value));
    }
  }
  return {{"point loads", points.wrenches()},
          {"face pressures", pressures.wrenches()},
          {"line loads", lines.wrenches()},
          {"silt", silt.wrenches()},
          {"body loads", bodies.wrenches()},
          {"inertia (earthquake)", earthquake.wrenches()},
          {"inertia ([base_motion])", inertia_of_shaking(scene, time_s)}};
}

Wrenches stated_loads_of(const scene::Scene& scene, double time_s) {
  Wrenches all(scene.blocks.size(), Wrench::Zero());
  for (NamedWrenches& part : stated_loads_by_name(scene, time_s)) all = combined(std::move(all), 1, part.wrenches);
  return all;
}

double stated_loads_hold_until(const scene::Scene& scene, double time_s) {
  double until = std::numeric_limits<double>::infinity();
  scene::each_load_table(scene,
                         [&](const scene::TimeTable& table) { until = std::min(until, table.constant_until(time_s)); });
  return until;
}

Wrenches prestress_of(const scene::Scene& scene) {
  Sum sum(scene);
  for (const scene::Bolt& bolt : scene.bolts) {
    const Point pull = bolt.prestress_n_per_m * (bolt.to_m - bolt.from_m).normalized();
    if (bolt.blocks[0] >= 0) sum.add(bolt.blocks[0], pull, bolt.from_m);
    if (bolt.blocks[1] >= 0) sum.add(bolt.blocks[1], -pull, bolt.to_m);
  }
  return sum.wrenches();
}

Wrenches water_forces(const scene::Scene& scene, const wire::Load& load) {
  return water_forces(scene, load, 0, load.block.size());
}

Wrenches water_forces(const scene::Scene& scene, const wire::Load& load, std::size_t first, std::size_t last) {
  Sum sum(scene);
  for (std::size_t i = first; i < last; ++i) {
    const auto& outline = scene.blocks[load.block[i]].vertices;
    const Point& a = outline[load.edge[i]];
    const Point span = outline[(load.edge[i] + 1) % outline.size()] - a;
    const Point from = a + load.s_from[i] * span;
    const Point to = a + load.s_to[i] * span;
    const auto block = static_cast<int>(load.block[i]);
    if (scene.water.nodal_rule == scene::NodalRule::lumped) {
      const Point half = (to - from).norm() / 2 * left_of(span);
      sum.add(block, load.pressure_from_pa[i] * half, from);
      sum.add(block, load.pressure_to_pa[i] * half, to);
    } else {
      sum.add_pressure(block, from, to, left_of(span), load.pressure_from_pa[i], load.pressure_to_pa[i]);
    }
  }
  return sum.wrenches();
}

}  // namespace blockweir::statics
