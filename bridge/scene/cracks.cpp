// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/scene/cracks.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <set>
#include <tuple>

#include "bridge/scene/at.hpp"
#include "bridge/scene/block_index.hpp"
#include "bridge/scene/unnamed_joint.hpp"

namespace blockweir::scene {
namespace {

/// The larger side of the box around all blocks, wherever it stands.
double size_of(const Scene& scene) {
  Eigen::AlignedBox2d box;
  for (const Block& block : scene.blocks) {
    for (const Point& p : block.vertices) box.extend(p);
  }
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

constexpr double touching_ratio = 1e-6;

/// Enlarged so that it overlaps the boxes of touching blocks.
geometry::Bounds grown(const geometry::Bounds& box, double touching_m) {
  const Point margin = Point::Constant(2 * touching_m);
  return {box.low - margin, box.high + margin};
}

/// Each joint whose uplift is one of these as a crack of its own.
std::vector<Crack> single_joints(const Scene& scene, double touching_m, const std::function<bool(Uplift)>& wanted) {
  std::vector<Crack> cracks;
  std::set<std::pair<int, int>> named;
  const auto add = [&](int a, int b, const JointLaw& law) {
    if (!wanted(law.uplift)) return;
    const auto& blocks = scene.blocks;
    JointTrace trace =
        trace_joint(blocks[static_cast<std::size_t>(a)], blocks[static_cast<std::size_t>(b)], touching_m);
    if (trace.pieces.empty()) return;
    const double length = trace.length_m;
    cracks.push_back({law.uplift, law.known_heads, {{a, b, std::move(trace)}}, length});
  };
  for (const Joint& joint : scene.joints) {
    add(joint.between[0], joint.between[1], joint.law);
    named.insert(std::minmax(joint.between[0], joint.between[1]));
  }
  if (!wanted(scene.default_joint.uplift)) return cracks;
  const BlockIndex index(scene.blocks);
  for (std::size_t a = 0; a < scene.blocks.size(); ++a) {
    std::vector<std::size_t> near = index.meeting(grown(geometry::bounds_of(scene.blocks[a].vertices), touching_m));
    std::sort(near.begin(), near.end());
    for (const std::size_t b : near) {
      const std::pair pair(static_cast<int>(a), static_cast<int>(b));
      if (b > a && named.count(pair) == 0) add(pair.first, pair.second, scene.default_joint);
    }
  }
  return cracks;
}

Point direction(const TracePiece& piece) {
  return (piece.to_m - piece.from_m).normalized();
}

/// Cosine of the turn from the end of one crack into the mouth of another; -1 where they are not the same crack.
double straightness(const Crack& before, const Crack& after, double touching_m) {
  const JointTrace& a = before.parts.back().trace;
  const JointTrace& b = after.parts.front().trace;
  if (before.law != after.law || !(before.known == after.known) || (a.end() - b.mouth()).norm() > touching_m) return -1;
  const double cosine = direction(a.pieces.back()).dot(direction(b.pieces.front()));
  return cosine > std::sqrt(0.5) ? cosine : -1;
}

/// Of one crack into another, both by their number. `parts` of the first one when it was found: with more of them it
/// ends elsewhere.
struct Continuation {
  double straightness;
  std::size_t before;
  std::size_t after;
  std::size_t parts;
  /// The straightest is last; of equally straight ones the one whose crack is first in the scene.
  bool operator<(const Continuation& other) const {
    return std::tie(straightness, other.before, other.after) < std::tie(other.straightness, before, after);
  }
};

/// Joins the straightest continuation as long as there is one.
void join(std::vector<Crack>& cracks, double touching_m) {
  std::vector<Point> all;
  for (const Crack& crack : cracks) all.push_back(crack.parts.front().trace.mouth());
  const geometry::BoxIndex mouths(all);
  std::priority_queue<Continuation> open;
  const auto look_on_from = [&](std::size_t before) {
    const Point& end = cracks[before].parts.back().trace.end();
    const Point margin = Point::Constant(2 * touching_m);
    for (const std::size_t after : mouths.meeting({end - margin, end + margin})) {
      if (after == before || cracks[after].parts.empty()) continue;
      const double straight = straightness(cracks[before], cracks[after], touching_m);
      if (straight > 0) open.push({straight, before, after, cracks[before].parts.size()});
    }
  };
  for (std::size_t i = 0; i < cracks.size(); ++i) look_on_from(i);
  while (!open.empty()) {
    const Continuation next = open.top();
    open.pop();
    Crack& before = cracks[next.before];
    Crack& after = cracks[next.after];
    if (before.parts.size() != next.parts || after.parts.empty()) continue;
    std::move(after.parts.begin(), after.parts.end(), std::back_inserter(before.parts));
    before.length_m += after.length_m;
    after.parts.clear();
    look_on_from(next.before);
  }
  std::erase_if(cracks, [](const Crack& crack) { return crack.parts.empty(); });
}

std::vector<Bend> bends_of(const Crack& crack) {
  std::vector<Bend> bends;
  double station_m = 0;
  bool straight = true;
  for (const CrackPart& part : crack.parts) {
    for (const TracePiece& piece : part.trace.pieces) {
      station_m += (piece.to_m - piece.from_m).norm();
      const double line_m = crack.mouth().y() + station_m / crack.length_m * (crack.end().y() - crack.mouth().y());
      bends.push_back({station_m, piece.to_m.y() - line_m});
      straight = straight && std::abs(bends.back().above_m) < touching_ratio * crack.length_m;
    }
  }
  bends.pop_back();  // the end
  return straight ? std::vector<Bend>() : bends;
}

}  // namespace

std::vector<Crack> find_cracks(const Scene& scene) {
  const double touching_m = touching_ratio * size_of(scene);
  std::vector<Crack> cracks = single_joints(scene, touching_m, [](Uplift law) { return is_profile(law); });
  join(cracks, touching_m);
  for (Crack& crack : cracks) crack.bends = bends_of(crack);
  return cracks;
}

std::vector<Crack> find_joints(const Scene& scene, Uplift law) {
  return single_joints(scene, touching_ratio * size_of(scene), [=](Uplift of_joint) { return of_joint == law; });
}

std::vector<Crack> find_flow_joints(const Scene& scene) {
  return find_joints(scene, Uplift::flow);
}

std::string name_of(const Scene& scene, const Crack& crack) {
  const CrackPart& part = crack.parts.front();
  for (const Joint& joint : scene.joints) {
    if (std::minmax(joint.between[0], joint.between[1]) == std::minmax(part.block_a, part.block_b)) return joint.name;
  }
  return unnamed_joint(scene, part.block_a, part.block_b);
}

std::vector<int> parted_by(const Scene& scene, const Crack& crack) {
  std::set<std::pair<int, int>> joints;
  for (const CrackPart& part : crack.parts) joints.insert(std::minmax(part.block_a, part.block_b));
  return parted_by(scene, joints);
}

std::vector<int> parted_by(const Scene& scene, const std::set<std::pair<int, int>>& joints) {
  std::vector<bool> held(scene.blocks.size(), false);
  std::vector<int> open;
  const auto hold = [&](int block) {
    if (held[at(block)]) return;
    held[at(block)] = true;
    open.push_back(block);
  };
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    if (scene.blocks[b].fixed) hold(static_cast<int>(b));
  }
  for (const Support& support : scene.supports) hold(support.block);
  for (const ViscousFace& face : scene.viscous_faces) hold(face.block);
  const double touching_m = touching_ratio * size_of(scene);
  const BlockIndex index(scene.blocks);
  while (!open.empty()) {
    const int from = open.back();
    open.pop_back();
    for (const std::size_t b : index.meeting(grown(geometry::bounds_of(scene.blocks[at(from)].vertices), touching_m))) {
      const int to = static_cast<int>(b);
      if (held[b] || joints.count(std::minmax(from, to)) > 0) continue;
      if (!trace_joint(scene.blocks[at(from)], scene.blocks[b], touching_m).pieces.empty()) hold(to);
    }
  }
  std::vector<int> parted;
  for (std::size_t b = 0; b < held.size(); ++b) {
    if (!held[b]) parted.push_back(static_cast<int>(b));
  }
  return parted;
}

}  // namespace blockweir::scene
