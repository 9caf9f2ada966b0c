// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/cracks.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <queue>
#include <set>
#include <tuple>

#include "bridge/scene/read/block_index.hpp"
#include "bridge/wire/panels.hpp"

namespace blockweir::hydrostatic {
namespace {

using scene::JointTrace;
using scene::Point;
using scene::TracePiece;

/// The larger side of the box around all blocks, wherever it stands.
double size_of(const scene::Scene& scene) {
  Eigen::AlignedBox2d box;
  for (const scene::Block& block : scene.blocks) {
    for (const Point& p : block.vertices) box.extend(p);
  }
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

/// Each joint with an uplift law as a crack of its own.
std::vector<Crack> single_joints(const scene::Scene& scene, double touching_m) {
  std::vector<Crack> cracks;
  std::set<std::pair<int, int>> named;
  const auto add = [&](int a, int b, scene::Uplift law) {
    if (law == scene::Uplift::none) return;
    const auto& blocks = scene.blocks;
    JointTrace trace =
        scene::trace_joint(blocks[static_cast<std::size_t>(a)], blocks[static_cast<std::size_t>(b)], touching_m);
    if (trace.pieces.empty()) return;
    const double length = trace.length_m;
    cracks.push_back({law, {{a, b, std::move(trace)}}, length});
  };
  for (const scene::Joint& joint : scene.joints) {
    add(joint.between[0], joint.between[1], joint.law.uplift);
    named.insert(std::minmax(joint.between[0], joint.between[1]));
  }
  if (scene.default_joint.uplift == scene::Uplift::none) return cracks;
  const scene::BlockIndex index(scene.blocks);
  for (std::size_t a = 0; a < scene.blocks.size(); ++a) {
    const Point margin = Point::Constant(2 * touching_m);
    geometry::Bounds reach = geometry::bounds_of(scene.blocks[a].vertices);
    reach = {reach.low - margin, reach.high + margin};
    std::vector<std::size_t> near = index.meeting(reach);
    std::sort(near.begin(), near.end());
    for (const std::size_t b : near) {
      const std::pair pair(static_cast<int>(a), static_cast<int>(b));
      if (b > a && named.count(pair) == 0) add(pair.first, pair.second, scene.default_joint.uplift);
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
  if (before.law != after.law || (a.end() - b.mouth()).norm() > touching_m) return -1;
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
  /// The straightest is last, of those as straight the one whose cracks come first in the scene.
  bool operator<(const Continuation& other) const {
    return std::tie(straightness, other.before, other.after) < std::tie(other.straightness, before, after);
  }
};

/// Joins the straightest continuation as long as there is one.
void join(std::vector<Crack>& cracks, double touching_m) {
  using Corner = boost::geometry::model::d2::point_xy<double>;
  using Mouth = std::pair<Corner, std::size_t>;
  const auto corner = [](const Point& p) { return Corner(p.x(), p.y()); };
  std::vector<Mouth> all;
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    all.emplace_back(corner(cracks[i].parts.front().trace.mouth()), i);
  }
  const boost::geometry::index::rtree<Mouth, boost::geometry::index::linear<16>> mouths(all);
  std::priority_queue<Continuation> open;
  const auto look_on_from = [&](std::size_t before) {
    const Point& end = cracks[before].parts.back().trace.end();
    const Point margin = Point::Constant(2 * touching_m);
    const boost::geometry::model::box<Corner> near(corner(end - margin), corner(end + margin));
    for (auto found = mouths.qbegin(boost::geometry::index::intersects(near)); found != mouths.qend(); ++found) {
      const std::size_t after = found->second;
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

/// Of an element: place along the edge, and pressure.
struct Node {
  double s;
  double pressure_pa;
};

/// The element from a to b, a.s <= b.s, without what open water reaches.
void add_closed_part(int block, int edge, Node a, Node b, const std::vector<WetInterval>& open_water,
                     wire::Load& load) {
  const auto add = [&](const Node& from, const Node& to) {
    wire::add_panel(load, block, edge, from.s, to.s, from.pressure_pa, to.pressure_pa);
  };
  const auto between = [whole_a = a, whole_b = b](double s) {
    const double share = (s - whole_a.s) / (whole_b.s - whole_a.s);
    return Node{s, whole_a.pressure_pa + share * (whole_b.pressure_pa - whole_a.pressure_pa)};
  };
  const auto before = [](const WetInterval& w, const std::pair<int, int>& face) {
    return std::pair(w.block, w.edge) < face;
  };
  const std::pair face(block, edge);
  for (auto open = std::lower_bound(open_water.begin(), open_water.end(), face, before);
       open != open_water.end() && std::pair(open->block, open->edge) == face; ++open) {
    if (open->s_to <= a.s || open->s_from >= b.s) continue;
    if (open->s_from > a.s) add(a, between(open->s_from));
    if (open->s_to >= b.s) return;
    a = between(open->s_to);
  }
  add(a, b);
}

}  // namespace

std::vector<Crack> find_cracks(const scene::Scene& scene) {
  const double touching_m = 1e-6 * size_of(scene);
  std::vector<Crack> cracks = single_joints(scene, touching_m);
  join(cracks, touching_m);
  return cracks;
}

void add_crack_elements(const Crack& crack, double mouth_pressure_pa, double end_pressure_pa, int elements_per_face,
                        const std::vector<WetInterval>& open_water, wire::Load& load) {
  if (crack.law == scene::Uplift::full)
    mouth_pressure_pa = end_pressure_pa = std::max(mouth_pressure_pa, end_pressure_pa);
  const double fall = mouth_pressure_pa - end_pressure_pa;
  double travelled = 0;
  for (const CrackPart& part : crack.parts) {
    for (const TracePiece& piece : part.trace.pieces) {
      const double length = (piece.to_m - piece.from_m).norm();
      const auto face = [&](int block, int edge, double s_from, double s_to) {
        const auto element_end = [&](int k) {
          const double share = static_cast<double>(k) / elements_per_face;
          return Node{s_from + (s_to - s_from) * share,
                      mouth_pressure_pa - fall * (travelled + length * share) / crack.length_m};
        };
        for (int k = 0; k < elements_per_face; ++k) {
          const Node a = element_end(k);
          const Node b = element_end(k + 1);
          add_closed_part(block, edge, a.s <= b.s ? a : b, a.s <= b.s ? b : a, open_water, load);
        }
      };
      face(part.block_a, piece.edge_a, piece.s_from_a, piece.s_to_a);
      face(part.block_b, piece.edge_b, piece.s_from_b, piece.s_to_b);
      travelled += length;
    }
  }
}

}  // namespace blockweir::hydrostatic
