// SPDX-License-Identifier: GPL-3.0-or-later
// Random masonry, and its cracks by a search of all pairs.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "bridge/scene/at.hpp"
#include "fluid/hydrostatic/crack_elements.hpp"

namespace blockweir::hydrostatic {

using scene::Crack;
using scene::CrackPart;
using scene::find_cracks;
using scene::Point;

/// Columns of blocks between lines that go up and down, each column with heights of its own or of its neighbour.
inline scene::Scene rubble(int columns, int rows, unsigned seed) {
  std::mt19937 random(seed);
  const auto any = [&](int most) { return static_cast<double>(random() % static_cast<unsigned>(most + 1)); };
  scene::Scene scene;
  scene.default_joint.uplift = scene::Uplift::triangular;
  std::vector<double> fall(at(columns + 1));
  for (double& f : fall) f = 0.2 * any(3);
  std::vector<double> heights(at(rows + 1));
  for (int c = 0; c < columns; ++c) {
    double height = 0;
    if (c == 0 || any(2) > 0) {
      for (double& h : heights) h = height, height += 1 + any(1);
    }
    for (int r = 0; r < rows; ++r) {
      const auto corner = [&](int x, int y) { return Point(c + x, heights[at(r + y)] - fall[at(c + x)]); };
      scene.blocks.emplace_back().vertices = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    }
  }
  for (int j = 0; j < columns; ++j) {  // some are named, with laws of their own
    scene::Joint& joint = scene.joints.emplace_back();
    joint.between = {j * rows, j * rows + 1};
    joint.law.uplift = j % 3 == 0 ? scene::Uplift::full : scene::Uplift::triangular;
  }
  return scene;
}

inline double straightness(const Crack& before, const Crack& after, double touching_m) {
  const auto along = [](const scene::TracePiece& piece) { return Point((piece.to_m - piece.from_m).normalized()); };
  const scene::JointTrace& a = before.parts.back().trace;
  const scene::JointTrace& b = after.parts.front().trace;
  if (before.law != after.law || (a.end() - b.mouth()).norm() > touching_m) return -1;
  return along(a.pieces.back()).dot(along(b.pieces.front()));
}

/// All pairs of blocks, then all pairs of cracks for each that is joined.
inline std::vector<Crack> cracks_by_all_pairs(const scene::Scene& scene, double touching_m) {
  std::vector<Crack> cracks;
  const auto add = [&](int a, int b, scene::Uplift law) {
    scene::JointTrace trace = scene::trace_joint(scene.blocks[at(a)], scene.blocks[at(b)], touching_m);
    const double length = trace.length_m;
    if (!trace.pieces.empty()) cracks.push_back({law, {}, {{a, b, trace}}, length});
  };
  for (const scene::Joint& joint : scene.joints) add(joint.between[0], joint.between[1], joint.law.uplift);
  for (int a = 0; a < static_cast<int>(scene.blocks.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(scene.blocks.size()); ++b) {
      const bool named = std::any_of(scene.joints.begin(), scene.joints.end(), [&](const scene::Joint& joint) {
        return joint.between[0] == a && joint.between[1] == b;
      });
      if (!named) add(a, b, scene.default_joint.uplift);
    }
  }
  for (;;) {
    double best = std::sqrt(0.5);
    std::size_t before = 0;
    std::size_t after = 0;
    for (std::size_t i = 0; i < cracks.size(); ++i) {
      for (std::size_t j = 0; j < cracks.size(); ++j) {
        const double found = i == j ? -1 : straightness(cracks[i], cracks[j], touching_m);
        if (found > best) best = found, before = i, after = j;
      }
    }
    if (before == after) return cracks;
    cracks[before].length_m += cracks[after].length_m;
    for (const CrackPart& part : cracks[after].parts) cracks[before].parts.push_back(part);
    cracks.erase(cracks.begin() + static_cast<std::ptrdiff_t>(after));
  }
}

}  // namespace blockweir::hydrostatic
