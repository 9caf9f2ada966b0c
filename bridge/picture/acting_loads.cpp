// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/acting_loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bridge/geometry/polygon.hpp"
#include "bridge/picture/acting_water.hpp"
#include "bridge/picture/json_point.hpp"
#include "bridge/picture/pressing.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/block_facts.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;
using scene::Point;

void put_at_point(const std::string& name, const char* kind, const Point& place, const Point& force, json& list) {
  if (force.isZero(0)) return;
  list.push_back(
      {{"name", name}, {"kind", kind}, {"force", pair(force)}, {"at", pair(place)}, {"strips", json::array()}});
}

/// Of forces on the mass or the volume of blocks, at their common centre.
class OnBlocks {
 public:
  explicit OnBlocks(const scene::Scene& scene) : scene_(scene) {}
  void add(std::size_t b, const Point& value, bool per_mass) {
    const scene::Block& block = scene_.blocks[b];
    if (block.fixed) return;
    const double area = geometry::signed_area(block.vertices);
    const Point force = (per_mass ? area * scene::material_of(scene_, block).density_kg_per_m3 : area) * value;
    force_ += force;
    middle_ += force.norm() * geometry::centroid(block.vertices);
    size_ += force.norm();
  }
  void put(const std::string& name, const char* kind, json& list) const {
    if (size_ > 0) put_at_point(name, kind, middle_ / size_, force_, list);
  }

 private:
  const scene::Scene& scene_;
  Point force_ = Point::Zero();
  Point middle_ = Point::Zero();
  double size_ = 0;
};

/// Unit normal of the edge nearest to a point of a counter-clockwise outline.
Point inwards_at(const std::vector<Point>& outline, const Point& place) {
  double least = std::numeric_limits<double>::infinity();
  Point inwards = Point::Zero();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point from = outline[i];
    const Point span = outline[(i + 1) % outline.size()] - from;
    const double share = std::clamp(span.dot(place - from) / span.squaredNorm(), 0.0, 1.0);
    const double away = (from + share * span - place).norm();
    if (away >= least) continue;
    least = away;
    inwards = Point(-span.y(), span.x()).normalized();
  }
  return inwards;
}

void put_on_blocks(const scene::Scene& scene, double time_s, json& list) {
  OnBlocks weight(scene);
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) weight.add(b, scene.analysis.gravity(), /*per_mass=*/true);
  weight.put("weight", "weight", list);
  for (const scene::BodyLoad& load : scene.body_loads) {
    OnBlocks sum(scene);
    for (const int b : load.blocks) {
      sum.add(at(b), {load.value[0].at(time_s), load.value[1].at(time_s)}, load.per_mass);
    }
    const bool stated = load.origin == scene::LoadOrigin::stated;
    sum.put(stated ? "body load" : "inertia (earthquake)", stated ? "load" : "earthquake", list);
  }
}

void put_on_edges(const scene::Scene& scene, double time_s, json& list) {
  for (const auto& load : scene.point_loads) {
    put_at_point("point load", "load", load.point_m, {load.force_x_n_per_m.at(time_s), load.force_y_n_per_m.at(time_s)},
                 list);
  }
  const auto vector = [&](const std::array<scene::TimeTable, 2>& q) { return Point(q[0].at(time_s), q[1].at(time_s)); };
  Pressing silt;
  for (const scene::LineLoad& load : scene.line_loads) {
    Pressing own;
    (load.origin == scene::LoadOrigin::stated ? own : silt)
        .add(load.from_m, load.to_m, vector(load.force_from_n_per_m2), vector(load.force_to_n_per_m2));
    own.put("line load", "load", list);
  }
  silt.put("silt", "silt", list);
  for (const auto& load : scene.face_pressures) {
    const Point inwards = inwards_at(scene.blocks[at(load.block)].vertices, (load.from_m + load.to_m) / 2);
    Pressing own;
    own.add(load.from_m, load.to_m, load.pressure_from_pa.at(time_s) * inwards,
            load.pressure_to_pa.at(time_s) * inwards);
    own.put("face pressure", "load", list);
  }
}

}  // namespace

json acting_loads(const scene::Scene& scene, const json& water, double time_s) {
  json list = json::array();
  put_on_blocks(scene, time_s, list);
  put_on_edges(scene, time_s, list);
  put_water(scene, water, list);
  return list;
}

json bolts_data(const scene::Scene& scene) {
  json list = json::array();
  for (const scene::Bolt& bolt : scene.bolts) {
    const auto block = [&](std::size_t end) {
      return bolt.blocks[end] < 0 ? json() : json(scene.blocks[at(bolt.blocks[end])].name);
    };
    list.push_back({{"name", bolt.name},
                    {"from", pair(bolt.from_m)},
                    {"to", pair(bolt.to_m)},
                    {"from_block", block(0)},
                    {"to_block", block(1)},
                    {"stiffness_n_per_m2", bolt.stiffness_n_per_m2},
                    {"prestress_n_per_m", bolt.prestress_n_per_m},
                    {"yield_n_per_m", bolt.yield_n_per_m ? json(*bolt.yield_n_per_m) : json()}});
  }
  return list;
}

}  // namespace blockweir::picture
