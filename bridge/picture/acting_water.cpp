// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/acting_water.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "bridge/geometry/outline.hpp"
#include "bridge/picture/acting_loads.hpp"
#include "bridge/picture/pressing.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/crest.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/unnamed_joint.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;
using scene::Point;

constexpr int from_upstream = 0;
constexpr int from_downstream = 1;
constexpr int on_the_crest = 2;

/// Names of the joints in which water presses on a block.
class JointNames {
 public:
  explicit JointNames(const scene::Scene& scene) : scene_(scene) {
    for (const scene::Joint& joint : scene.joints) {
      traces_.push_back(scene::trace_joint(scene.blocks[at(joint.between[0])], scene.blocks[at(joint.between[1])],
                                           near * scene::structure_size_m(scene.blocks)));
    }
  }
  /// Name of the uplift at `place` in the joint of `block` with `other`, as the tables have it; where the other one is
  /// not known, that of the block.
  [[nodiscard]] std::string uplift_at(int block, int other, const Point& place) const {
    const double near_m = near * scene::structure_size_m(scene_.blocks);
    for (std::size_t j = 0; j < traces_.size(); ++j) {
      const scene::Joint& joint = scene_.joints[j];
      if (joint.between[0] != block && joint.between[1] != block) continue;
      for (const scene::TracePiece& piece : traces_[j].pieces) {
        if (geometry::distance_to_segment(place, piece.from_m, piece.to_m) > near_m) continue;
        return "uplift in " + (joint.set.empty() ? joint.name : joint.set);
      }
    }
    if (block == unknown_block) return "uplift";
    if (other == unknown_block) return "uplift under " + scene_.blocks[at(block)].name;
    return "uplift in " + scene::unnamed_joint(scene_, block, other);
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
  [[nodiscard]] Point middle() const { return (from + to) / 2; }
  [[nodiscard]] Point force() const { return (pressure_pa[0] + pressure_pa[1]) / 2 * (to - from).norm() * inwards; }
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

/// The pools part at the middle of the crest, as for the water's own model. A face that looks down may hang over that
/// line: its pool is in front of it.
int side_of(const Panel& p, const scene::Crest& crest) {
  const bool crowns = p.inwards.y() < -0.5 && std::min(p.from.y(), p.to.y()) >= crest.low_m;
  if (crowns) return on_the_crest;
  const bool overhangs = p.inwards.y() > 1e-9;
  const bool beyond = p.middle().x() > (crest.left_m + crest.right_m) / 2;
  return (overhangs ? p.inwards.x() < 0 : beyond) ? from_downstream : from_upstream;
}

/// Of the pressures of open water, those from upstream, from downstream and on the crest.
std::map<int, Pressing> parts_of(const scene::Scene& scene, const json& panels) {
  std::map<int, Pressing> parts;
  const scene::Crest crest = scene::crest_of(scene.blocks);
  for (const Panel& p : panels_of(scene, panels)) p.add_to(parts[side_of(p, crest)]);
  return parts;
}

/// Finds the panel on the other face of a joint.
class Faces {
 public:
  Faces(const scene::Scene& scene, const std::vector<Panel>& panels)
      : panels_(panels), near_m_(1e-6 * scene::structure_size_m(scene.blocks)) {
    for (std::size_t i = 0; i < panels.size(); ++i) by_x_.emplace(panels[i].middle().x(), i);
  }
  /// Null where none is known, as where the run did not store the blocks.
  [[nodiscard]] const Panel* opposite(const Panel& panel) const {
    const Point middle = panel.middle();
    const auto end = by_x_.upper_bound(middle.x() + near_m_);
    for (auto it = by_x_.lower_bound(middle.x() - near_m_); it != end; ++it) {
      const Panel& other = panels_[it->second];
      if (other.block != panel.block && (other.middle() - middle).norm() <= near_m_) return &other;
    }
    return nullptr;
  }

 private:
  const std::vector<Panel>& panels_;
  double near_m_;
  std::multimap<double, std::size_t> by_x_{};
};

/// With the block on the other face.
using JointPanel = std::pair<Panel, int>;

/// What presses on the structure in joints: on ground all of it; between two blocks that can move, on the upper one, in
/// an upright joint on the one further downstream. A bent joint has one upper block, which its upright legs press, too.
std::vector<JointPanel> uplifting(const scene::Scene& scene, const json& json_panels) {
  const std::vector<Panel> all(json_panels.begin(), json_panels.end());
  const Faces faces(scene, all);
  const auto is_fixed = [&](const Panel& p) { return p.block != unknown_block && scene.blocks[at(p.block)].fixed; };
  std::map<std::pair<int, int>, Eigen::Vector3d> on_block_from;  // force, and its size
  std::vector<const Panel*> opposite;
  for (const Panel& p : all) {
    opposite.push_back(faces.opposite(p));
    if (opposite.back() == nullptr) continue;
    const Point force = p.force();
    on_block_from.try_emplace({p.block, opposite.back()->block}, Eigen::Vector3d::Zero()).first->second +=
        Eigen::Vector3d(force.x(), force.y(), force.norm());
  }
  std::vector<JointPanel> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    constexpr double round_off = 1e-9;
    if (is_fixed(all[i])) continue;
    bool counts = all[i].inwards.y() > 0;
    if (const Panel* other = opposite[i]) {
      const Eigen::Vector3d& force = on_block_from.at({all[i].block, other->block});
      const bool is_upright = std::abs(force.y()) <= round_off * force.z();
      counts = is_fixed(*other) || (is_upright ? force.x() > 0 : force.y() > 0);
    }
    if (counts) kept.emplace_back(all[i], opposite[i] == nullptr ? unknown_block : opposite[i]->block);
  }
  return kept;
}

/// A resultant for each joint.
void put_uplift(const scene::Scene& scene, const json& panels, json& list) {
  constexpr std::size_t most_named = 12;  // of a mesh of joints no picture can name each
  const JointNames names(scene);
  std::map<std::string, Pressing> parts;
  for (const auto& [p, other] : uplifting(scene, panels)) p.add_to(parts[names.uplift_at(p.block, other, p.middle())]);
  for (const auto& [name, pressing] : parts) {
    pressing.put(parts.size() <= most_named ? name : std::string("uplift"), "uplift", list);
  }
}

}  // namespace

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

}  // namespace blockweir::picture
