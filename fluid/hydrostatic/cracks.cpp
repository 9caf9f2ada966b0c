// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/cracks.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "bridge/wire/panels.hpp"

namespace blockweir::hydrostatic {
namespace {

using scene::JointTrace;
using scene::Point;
using scene::TracePiece;

double size_of(const scene::Scene& scene) {
  double size = 0;
  for (const scene::Block& block : scene.blocks) {
    for (const Point& p : block.vertices) size = std::max(size, p.cwiseAbs().maxCoeff());
  }
  return size;
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
  const int n = scene.default_joint.uplift == scene::Uplift::none ? 0 : static_cast<int>(scene.blocks.size());
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      if (named.count({a, b}) == 0) add(a, b, scene.default_joint.uplift);
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

/// Joins the straightest continuation there is; false where there is none.
bool join_one(std::vector<Crack>& cracks, double touching_m) {
  double best = 0;
  std::size_t before = 0;
  std::size_t after = 0;
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    for (std::size_t j = 0; j < cracks.size(); ++j) {
      const double found = i == j ? -1 : straightness(cracks[i], cracks[j], touching_m);
      if (found > best) best = found, before = i, after = j;
    }
  }
  if (best <= 0) return false;
  auto& parts = cracks[before].parts;
  auto& more = cracks[after].parts;
  std::move(more.begin(), more.end(), std::back_inserter(parts));
  cracks[before].length_m += cracks[after].length_m;
  cracks.erase(cracks.begin() + static_cast<std::ptrdiff_t>(after));
  return true;
}

}  // namespace

std::vector<Crack> find_cracks(const scene::Scene& scene) {
  const double touching_m = 1e-6 * size_of(scene);
  std::vector<Crack> cracks = single_joints(scene, touching_m);
  while (join_one(cracks, touching_m)) {
  }
  return cracks;
}

void add_crack_elements(const Crack& crack, double mouth_pressure_pa, double end_pressure_pa, wire::Load& load) {
  const double fall = crack.law == scene::Uplift::full ? 0 : mouth_pressure_pa - end_pressure_pa;
  double travelled = 0;
  for (const CrackPart& part : crack.parts) {
    for (const TracePiece& piece : part.trace.pieces) {
      const double p_from = mouth_pressure_pa - fall * travelled / crack.length_m;
      travelled += (piece.to_m - piece.from_m).norm();
      const double p_to = mouth_pressure_pa - fall * travelled / crack.length_m;
      const auto face = [&](int block, int edge, double s_from, double s_to) {
        if (s_from <= s_to) {
          wire::add_panel(load, block, edge, s_from, s_to, p_from, p_to);
        } else {
          wire::add_panel(load, block, edge, s_to, s_from, p_to, p_from);
        }
      };
      face(part.block_a, piece.edge_a, piece.s_from_a, piece.s_to_a);
      face(part.block_b, piece.edge_b, piece.s_from_b, piece.s_to_b);
    }
  }
}

}  // namespace blockweir::hydrostatic
