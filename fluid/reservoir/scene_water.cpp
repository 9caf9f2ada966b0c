// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/scene_water.hpp"

#include <algorithm>
#include <limits>

namespace blockweir::reservoir {
namespace {

/// Far end of long water: the motion that reaches farthest, exp(-pi x/2H), has sunk to 1e-6 of itself there and back.
constexpr double long_in_depths = 5;

/// Waves are damped from the first to the second. Less than 1 % of them comes back
/// (tests/verification/reservoir_waves_test): long ones need the way, and coarse triangles make it cheap.
constexpr double absorbs_from_depths = 2;
constexpr double absorbs_to_depths = 62;

Fineness fineness_of(const scene::Scene& scene) {
  constexpr double corner = 0.01;  // of the widest
  constexpr double growth = 0.35;
  const double widest = scene.reservoir.element_ratio;
  return {widest, corner * widest, growth};
}

FarEnds far_ends(const scene::Scene& scene, const std::vector<std::vector<Point>>& outlines, double deep_m) {
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  for (const auto& outline : outlines) {
    for (const Point& p : outline) left = std::min(left, p.x()), right = std::max(right, p.x());
  }
  const auto end = [&](const std::optional<double>& wall_m, double model_m, int side) {
    if (wall_m) return FarEnd{*wall_m, true, {}};
    if (!physics_of(scene).remembers()) return FarEnd{model_m + side * long_in_depths * deep_m, false, {}};
    return FarEnd{model_m + side * absorbs_to_depths * deep_m, false, model_m + side * absorbs_from_depths * deep_m};
  };
  return {end(scene.reservoir.upstream_wall_m, left, -1), end(scene.reservoir.downstream_wall_m, right, 1)};
}

}  // namespace

WaterPhysics physics_of(const scene::Scene& scene) {
  WaterPhysics physics{.density_kg_per_m3 = scene.water.density_kg_per_m3};
  if (scene.reservoir.compressible) {
    physics.sound_speed_m_per_s = scene.reservoir.sound_speed_m_per_s;
    physics.bottom_reflection = scene.reservoir.bottom_reflection;
  }
  if (scene.reservoir.surface_waves) physics.gravity_m_per_s2 = scene.analysis.gravity_m_per_s2;
  return physics;
}

WaterMesh mesh_of(const scene::Scene& scene, const hydrostatic::WaterBody& body,
                  const std::vector<std::vector<Point>>& outlines) {
  return mesh_water(body, outlines, far_ends(scene, outlines, depth(body)), fineness_of(scene));
}

}  // namespace blockweir::reservoir
