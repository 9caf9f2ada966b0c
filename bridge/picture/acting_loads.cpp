// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/acting_loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/picture/json_point.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/block_facts.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;
using scene::Point;

/// A load that is being put together from what presses along edges.
class Pressing {
 public:
  /// A force a metre that is linear from one point to the other; it goes on where the last one ended.
  void add(const Point& from, const Point& to, const Point& q_from, const Point& q_to) {
    const double length = (to - from).norm();
    if (length == 0 || (q_from.isZero(0) && q_to.isZero(0))) return;
    force_ += length / 2 * (q_from + q_to);
    middle_ += length / 6 * ((2 * q_from.norm() + q_to.norm()) * from + (q_from.norm() + 2 * q_to.norm()) * to);
    size_ += length / 2 * (q_from.norm() + q_to.norm());
    if (strips_.empty() || (from - end_).norm() > 1e-9 * length) strips_.push_back(json::array());
    strips_.back().push_back({from.x(), from.y(), q_from.x(), q_from.y()});
    strips_.back().push_back({to.x(), to.y(), q_to.x(), q_to.y()});
    end_ = to;
  }
  void put(const std::string& name, const char* kind, json& list) const {
    if (size_ == 0) return;
    list.push_back(
        {{"name", name}, {"kind", kind}, {"force", pair(force_)}, {"at", pair(middle_ / size_)}, {"strips", strips_}});
  }

 private:
  json strips_ = json::array();
  Point end_ = Point::Zero();
  Point force_ = Point::Zero();
  Point middle_ = Point::Zero();
  double size_ = 0;
};

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

constexpr int from_upstream = 0;
constexpr int from_downstream = 1;
constexpr int on_the_crest = 2;

/// The highest point of what can move.
double crest_m(const scene::Scene& scene) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const scene::Block& block : scene.blocks) {
    for (const Point& p : block.vertices) highest = block.fixed ? highest : std::max(highest, p.y());
  }
  return highest;
}

/// Names of the joints in which water presses on a block.
class JointNames {
 public:
  explicit JointNames(const scene::Scene& scene) : scene_(scene) {
    for (const scene::Joint& joint : scene.joints) {
      traces_.push_back(scene::trace_joint(scene.blocks[at(joint.between[0])], scene.blocks[at(joint.between[1])],
                                           near * scene::structure_size_m(scene.blocks)));
    }
  }
  /// Name of the uplift on a named joint of `block` at `place`; without a joint's name, that of the block.
  [[nodiscard]] std::string uplift_at(int block, const Point& place) const {
    const double near_m = near * scene::structure_size_m(scene_.blocks);
    for (std::size_t j = 0; j < traces_.size(); ++j) {
      const scene::Joint& joint = scene_.joints[j];
      if (joint.between[0] != block && joint.between[1] != block) continue;
      for (const scene::TracePiece& piece : traces_[j].pieces) {
        if (geometry::distance_to_segment(place, piece.from_m, piece.to_m) > near_m) continue;
        return "uplift in " + (joint.set.empty() ? joint.name : joint.set);
      }
    }
    return block == unknown_block ? "uplift" : "uplift under " + scene_.blocks[at(block)].name;
  }

 private:
  static constexpr double near = 1e-6;  // of the structure
  const scene::Scene& scene_;
  std::vector<scene::JointTrace> traces_{};
};

/// A straight part of a block's boundary, pressed.
struct Panel {
  explicit Panel(const json& p)
      : block(p[6]),
        from(p[0], p[1]),
        to(p[2], p[3]),
        inwards(Point(from.y() - to.y(), to.x() - from.x()).normalized()),
        pressure_pa{p[4], p[5]} {}
  void add_to(Pressing& pressing) const { pressing.add(from, to, pressure_pa[0] * inwards, pressure_pa[1] * inwards); }

  int block;
  Point from;
  Point to;
  Point inwards;
  std::array<double, 2> pressure_pa;
};

/// Those on blocks that can move, or on ones that are not known.
std::vector<Panel> panels_of(const scene::Scene& scene, const json& panels) {
  std::vector<Panel> all(panels.begin(), panels.end());
  std::erase_if(all, [&](const Panel& p) { return p.block != unknown_block && scene.blocks[at(p.block)].fixed; });
  return all;
}

/// Of the pressures of open water, those from upstream, from downstream and on the crest.
std::map<int, Pressing> parts_of(const scene::Scene& scene, const json& panels) {
  std::map<int, Pressing> parts;
  const double crest = crest_m(scene);
  const auto side = [&](const Panel& p) {
    constexpr double level = 1e-3;  // of a crest's width
    const bool crowns =
        p.inwards.y() < -0.5 && crest - std::min(p.from.y(), p.to.y()) <= level * (p.to - p.from).norm();
    return crowns ? on_the_crest : p.inwards.x() < -1e-9 ? from_downstream : from_upstream;
  };
  for (const Panel& p : panels_of(scene, panels)) p.add_to(parts[side(p)]);
  return parts;
}

/// A resultant for each named joint, and one for all that stands on other joints of a block. Of both sides of a joint
/// the upper block's counts.
void put_uplift(const scene::Scene& scene, const json& panels, json& list) {
  constexpr std::size_t most_named = 12;  // of a mesh of joints no picture can name each
  const JointNames names(scene);
  std::map<std::string, Pressing> parts;
  for (const Panel& p : panels_of(scene, panels)) {
    if (p.inwards.y() > 0) p.add_to(parts[names.uplift_at(p.block, (p.from + p.to) / 2)]);
  }
  for (const auto& [name, pressing] : parts) {
    pressing.put(parts.size() <= most_named ? name : std::string("uplift"), "uplift", list);
  }
}

void put_water(const scene::Scene& scene, const json& water, json& list) {
  const std::map<std::string, const char*> kinds = {{"open water", "water"},
                                                    {"ice", "ice"},
                                                    {"added water (Westergaard)", "added water"},
                                                    {"added water (finite elements)", "added water"}};
  for (const json& kind : water) {
    const std::string name = kind["name"];
    if (name == "water in joints") {
      put_uplift(scene, kind["panels"], list);
      continue;
    }
    const auto parts = parts_of(scene, kind["panels"]);
    const auto name_of = [&](int part) {
      const char* where = part == on_the_crest ? " on the crest" : part == from_upstream ? " upstream" : " downstream";
      if (name == "open water") return std::string("water") + where;
      return name + (parts.size() == 1 ? "" : where);
    };
    for (const auto& [part, pressing] : parts) {
      const std::size_t before = list.size();
      pressing.put(name_of(part), kinds.at(name), list);
      if (list.size() > before) list.back()["from_downstream"] = part == from_downstream;
    }
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
