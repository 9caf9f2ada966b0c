// SPDX-License-Identifier: GPL-3.0-or-later
// Seepage flow through joints, as a scene states it; fluid/joints has the equations.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bridge/geometry/point.hpp"

namespace blockweir::scene {

using geometry::Point;

/// Steady in each coupling window, or transient: with the water that joints store as they open, close and fill.
enum class FlowKind { steady, transient };

/// A line of drains. Where it crosses a joint it sets the head, or removes a share of the head above it.
struct DrainLine {
  std::string name;
  Point from_m;
  Point to_m;
  std::optional<double> head_m{};  ///< head in the drain, an elevation y; none: atmospheric pressure at the crossing
  double efficiency = 1;
  int line = 0;  ///< where the scene file states it
  bool operator==(const DrainLine&) const = default;
};

/// A region in which closed joints have a smaller aperture.
struct Grout {
  std::string name;
  std::vector<Point> outline_m;
  double aperture_factor = 1;
  int line = 0;
  bool operator==(const Grout&) const = default;
};

struct JointFlow {
  FlowKind kind = FlowKind::steady;
  double viscosity_pa_s = 1.3e-3;           ///< of water at 10 degrees
  std::optional<double> bulk_modulus_pa{};  ///< of water, in transient flow; none: incompressible
  int panels_per_joint = 1;                 ///< for each part of a joint between two blocks
  std::vector<DrainLine> drains;
  std::vector<Grout> grouts;
  bool operator==(const JointFlow&) const = default;
};

struct Scene;
/// Whether water flows through a joint of the scene, or can once blocks touch.
bool flows_in_joints(const Scene& scene);

}  // namespace blockweir::scene
