// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/reservoir_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/scene/at.hpp"
#include "bridge/scene/crest.hpp"
#include "bridge/scene/hydrostatics.hpp"
#include "bridge/wire/panels.hpp"

namespace blockweir::hydrostatic {
namespace {

enum class Looks { upstream, downstream };

/// A wet part of an edge that does not lie level. Outlines run counter-clockwise: one that looks upstream leads down.
struct WetFace {
  const WetInterval* wet;
  Point from;
  Point to;
  double normal_x;  ///< size

  [[nodiscard]] double top() const { return std::max(from.y(), to.y()); }
  [[nodiscard]] double bottom() const { return std::min(from.y(), to.y()); }
  [[nodiscard]] double share(double y) const {
    const double along = (y - from.y()) / (to.y() - from.y());
    const double s = wet->s_from + (wet->s_to - wet->s_from) * along;
    return std::clamp(s, wet->s_from, wet->s_to);  // not by a rounding more, which the wire refuses
  }
  /// Linear pressure between two heights.
  void press(double high, double high_pa, double low, double low_pa, wire::Load& load) const {
    if (from.y() > to.y()) {
      wire::add_panel(load, wet->block, wet->edge, share(high), share(low), high_pa, low_pa);
    } else {
      wire::add_panel(load, wet->block, wet->edge, share(low), share(high), low_pa, high_pa);
    }
  }
};

std::vector<WetFace> faces_that(Looks looks, const scene::Scene& scene, const std::vector<std::vector<Point>>& outlines,
                                const WaterBody& pool) {
  std::vector<WetFace> faces;
  for (const WetInterval& wet : pool.wet->intervals) {
    if (scene.blocks[at(wet.block)].fixed) continue;
    const auto& outline = outlines[at(wet.block)];
    const Point& a = outline[at(wet.edge)];
    const Point span = outline[(at(wet.edge) + 1) % outline.size()] - a;
    const double down = looks == Looks::upstream ? -span.y() : span.y();
    if (down <= 1e-9 * span.norm()) continue;
    const WetFace face{&wet, a + wet.s_from * span, a + wet.s_to * span, down / span.norm()};
    if (face.bottom() < face.top()) faces.push_back(face);
  }
  return faces;
}

void add_ice(const std::vector<WetFace>& faces, const scene::Ice& ice, double level_m, wire::Load& load) {
  const double pressure = ice.thrust_n_per_m / ice.thickness_m;
  for (const WetFace& face : faces) {
    const double low = std::max(face.bottom(), level_m - ice.thickness_m);
    const double high = std::min(face.top(), level_m);
    if (low < high) face.press(high, pressure, low, pressure, load);
  }
}

/// Linear pressures with the force and the moment of factor sqrt(z) between the depths a^2 and b^2: their integrals
/// over (b - a)(b + a) and its square, divided out, as a face may be as thin as a rounding.
std::pair<double, double> of_same_force_and_moment(double factor, double z_from, double z_to) {
  const double a = std::sqrt(z_from);
  const double b = std::sqrt(z_to);
  if (a + b == 0) return {0, 0};
  const double mean = factor * 2 / 3 * (a * a + a * b + b * b) / (a + b);
  const double lever =
      factor * 2 / 15 * (3 * b * b * b + 6 * a * b * b + 4 * a * a * b + 2 * a * a * a) / ((a + b) * (a + b));
  return {4 * mean - 6 * lever, 6 * lever - 2 * mean};
}

void add_westergaard(const std::vector<WetFace>& faces, double weight_times_coefficient, double level_m,
                     wire::Load& load) {
  constexpr int elements = 10;
  double foot = std::numeric_limits<double>::infinity();
  for (const WetFace& face : faces) foot = std::min(foot, face.bottom());
  const double root_of_depth = std::sqrt(std::max(0.0, level_m - foot));
  for (const WetFace& face : faces) {
    const double factor = 7.0 / 8 * weight_times_coefficient * root_of_depth * face.normal_x;
    const double top = std::max(0.0, level_m - face.top());
    const double bottom = level_m - face.bottom();
    for (int k = 0; k < elements; ++k) {
      const double z_from = top + (bottom - top) * k / elements;
      const double z_to = top + (bottom - top) * (k + 1) / elements;
      const auto [from_pa, to_pa] = of_same_force_and_moment(factor, z_from, z_to);
      face.press(level_m - z_from, from_pa, level_m - z_to, to_pa, load);
    }
  }
}

void add_crest(const scene::Scene& scene, const std::vector<std::vector<Point>>& outlines,
               const std::vector<WaterBody>& bodies, wire::Load& load) {
  const scene::Crest crest = scene::crest_of(scene.blocks, outlines);
  const double level_m = bodies.front().surface.from_m.y();
  if (crest.edges.empty() || level_m <= crest.height_m) return;
  const auto is_wet = [&](const scene::CrestEdge& edge) {
    return std::any_of(bodies.begin(), bodies.end(), [&](const WaterBody& body) {
      const auto& wet = body.wet->intervals;
      return std::any_of(wet.begin(), wet.end(),
                         [&](const WetInterval& w) { return w.block == edge.block && w.edge == edge.edge; });
    });
  };
  // Water between two pools presses there already, by the same law.
  if (std::any_of(crest.edges.begin(), crest.edges.end(), is_wet)) return;
  const double head = scene::in_joints(scene, level_m).pressure(crest.height_m);
  const bool falls = scene.water.crest_pressure == scene::CrestPressure::triangular;
  const auto pressure = [&](double x) {
    return falls ? head * (crest.right_m - x) / (crest.right_m - crest.left_m) : head;
  };
  for (const scene::CrestEdge& edge : crest.edges) {
    wire::add_panel(load, edge.block, edge.edge, 0, 1, pressure(edge.right_m), pressure(edge.left_m));
  }
}

}  // namespace

void add_reservoir_loads(const scene::Scene& scene, const std::vector<std::vector<Point>>& outlines,
                         const std::vector<WaterBody>& bodies, wire::Load& load) {
  const scene::Water& water = scene.water;
  if (water.crest_pressure != scene::CrestPressure::none) add_crest(scene, outlines, bodies, load);
  const bool westergaard = water.earthquake_coefficient != 0 && water.added_water == scene::AddedWater::westergaard;
  if (!water.ice && !westergaard) return;
  const double level_m = bodies.front().surface.from_m.y();
  const std::vector<WetFace> upstream = faces_that(Looks::upstream, scene, outlines, bodies.front());
  if (water.ice) add_ice(upstream, *water.ice, level_m, load);
  if (!westergaard) return;
  const double weight = water.earthquake_coefficient * scene::unit_weight_of_water(scene);
  add_westergaard(upstream, weight, level_m, load);
  if (!water.downstream_level_m) return;
  // The ground that pushes the dam into the reservoir draws it away from the tailwater.
  const WaterBody& tailwater = bodies.size() > 1 ? bodies[1] : bodies.front();
  add_westergaard(faces_that(Looks::downstream, scene, outlines, tailwater), -weight, tailwater.surface.from_m.y(),
                  load);
}

}  // namespace blockweir::hydrostatic
