// SPDX-License-Identifier: GPL-3.0-or-later
// Finds where faces of two blocks lie along each other at present, and the gap between them: the channels of seepage.
#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bridge/scene/scene.hpp"

namespace blockweir::joints {

using scene::Point;

/// A part of a block's edge; fractions 0..1 along the edge at both ends of the stretch.
struct Side {
  int block = 0;
  int edge = 0;
  double s_from = 0;
  double s_to = 0;
};

/// Two faces opposite each other; all quantities are linear between its ends.
struct Stretch {
  std::array<Side, 2> sides;
  Point from;  ///< midway between the faces
  Point to;
  std::array<double, 2> gap_m{};  ///< between the faces at both ends; negative if they overlap
  const scene::JointLaw* law = nullptr;

  [[nodiscard]] double length_m() const { return (to - from).norm(); }
  [[nodiscard]] Point place(double share) const { return from + share * (to - from); }
};

class JointStretches {
 public:
  /// For joints with uplift = "flow". Faces farther apart than `open_m` are not a joint: open water is between them.
  JointStretches(const scene::Scene& scene, double open_m);

  /// Whether there are none, now or after blocks come into contact.
  [[nodiscard]] bool empty() const { return !flows_; }
  /// Sorted by pair of blocks and edges.
  std::vector<Stretch> find(const std::vector<std::vector<Point>>& outlines);
  /// Blocks near each other, from the last find().
  [[nodiscard]] const std::vector<std::vector<int>>& neighbours() const { return neighbours_; }
  /// The name of the joint, or of its two blocks.
  [[nodiscard]] std::string name(const Stretch& stretch) const;

 private:
  struct Pair {
    int a;
    int b;
    const scene::JointLaw* law;
  };
  void search(const std::vector<std::vector<Point>>& outlines);
  [[nodiscard]] const scene::JointLaw& law(int a, int b) const;

  const scene::Scene& scene_;
  double open_m_;
  bool flows_ = false;
  std::map<std::pair<int, int>, const scene::Joint*> named_;
  std::vector<Pair> pairs_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<std::vector<Point>> searched_;  ///< outlines of the last search
};

}  // namespace blockweir::joints
