// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/scene_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "bridge/scene/at.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/water_answers.hpp"

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

/// The block that lies on the water.
std::string cover_of(const scene::Scene& scene, const WaterMesh& mesh) {
  const BoundarySide* highest = nullptr;
  for (const BoundarySide& side : mesh.side) {
    const auto height = [&](const BoundarySide& s) { return mesh.node[at(s.node[1])].y(); };
    if (side.block >= 0 && (highest == nullptr || height(side) > height(*highest))) highest = &side;
  }
  return highest == nullptr ? "ground" : fmt::format("block \"{}\"", scene.blocks[at(highest->block)].name);
}

/// Water that is shut in cannot give way: its pressure has no answer.
void require_surface(const scene::Scene& scene, const WaterMesh& mesh) {
  const auto is_surface = [](const BoundarySide& side) { return side.kind == BoundarySide::Kind::surface; };
  if (mesh.side.empty() || std::any_of(mesh.side.begin(), mesh.side.end(), is_surface)) return;
  throw std::runtime_error(
      fmt::format("{}: [fluid.reservoir] has a pool without a surface: {} covers all of it; expected a free surface on "
                  "each pool; lower its level, or move its wall off",
                  scene.file.string(), cover_of(scene, mesh)));
}

/// All but the trapezoidal rule, which blocks and water must have in common to make no energy: of what no window
/// resolves, as after an impact, 2 % are lost in each.
constexpr double nearly_trapezoidal = 1 / 1.98;

}  // namespace

WaterPhysics physics_of(const scene::Scene& scene) {
  WaterPhysics physics{.density_kg_per_m3 = scene.water.density_kg_per_m3};
  if (scene.reservoir.compressible) {
    physics.sound_speed_m_per_s = scene.reservoir.sound_speed_m_per_s;
    physics.bottom_reflection = scene.reservoir.bottom_reflection;
    const bool damps = scene.analysis.integrator == scene::Integrator::shi;
    if (scene::answers_ahead(scene) && !damps) physics.theta = nearly_trapezoidal;
  }
  if (scene.reservoir.surface_waves) physics.gravity_m_per_s2 = scene.analysis.gravity_m_per_s2;
  return physics;
}

bool is_film(const scene::Scene& scene, const hydrostatic::WaterBody& body) {
  constexpr double film = 5e-3;  // of the structure's size
  return depth(body) <= film * scene::structure_size_m(scene.blocks);
}

FarEnds far_ends(const scene::Scene& scene, const hydrostatic::WaterBody& body, const Banks& banks) {
  const double deep_m = depth(body);
  const Extent model = extent_of(banks.outlines);
  const auto end = [&](const std::optional<double>& wall_m, double model_m, int side) {
    if (wall_m) return FarEnd{*wall_m + banks.ground_m.x(), true, {}};
    if (!physics_of(scene).remembers()) return FarEnd{model_m + side * long_in_depths * deep_m, false, {}};
    return FarEnd{model_m + side * absorbs_to_depths * deep_m, false, model_m + side * absorbs_from_depths * deep_m};
  };
  return {end(scene.reservoir.upstream_wall_m, model.left_m, -1),
          end(scene.reservoir.downstream_wall_m, model.right_m, 1)};
}

WaterMesh mesh_of(const scene::Scene& scene, const hydrostatic::WaterBody& body, const Banks& banks) {
  if (is_film(scene, body)) return {};
  WaterMesh mesh = mesh_water(body, banks, far_ends(scene, body, banks), fineness_of(scene));
  require_surface(scene, mesh);
  return mesh;
}

}  // namespace blockweir::reservoir
