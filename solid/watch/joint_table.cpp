// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/joint_table.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "solid/watch/linear_stress.hpp"
#include "solid/watch/surface_sum.hpp"

namespace blockweir::solid {
namespace {

/// Of a surface, along it: from end to end, but for galleries and other voids.
std::vector<FaceStretch> faces_of(const Solid& solid, const std::set<std::pair<int, int>>& joint, const JointRow& row) {
  constexpr double rounded = 1e-4;  // of the structure's size: faces so near touch
  const double near_m = rounded * solid.model().size_m;
  std::vector<FaceStretch> faces;
  const Point along = (row.downstream_end_m - row.upstream_end_m).normalized();
  for (const auto& [i, j] : joint) {
    const auto trace = scene::trace_joint(solid.scene().blocks[at(i)], solid.scene().blocks[at(j)], near_m);
    for (const scene::TracePiece& piece : trace.pieces) {
      const auto [from_m, to_m] =
          std::minmax({along.dot(piece.from_m - row.upstream_end_m), along.dot(piece.to_m - row.upstream_end_m)});
      faces.push_back({from_m, to_m});
    }
  }
  faces = joined(std::move(faces), near_m);
  if (faces.size() < 2) return {{0, row.length_m}};
  faces.front().from_m = 0;
  faces.back().to_m = row.length_m;
  return faces;
}

void add_stresses(const std::vector<FaceStretch>& faces, double r, JointRow& row) {
  const LinearStress stress = linear_stress(faces, row.normal_n_per_m, (1 - r) * row.length_m);
  row.heel_stress_pa = -stress.upstream_pa;
  row.toe_stress_pa = -stress.downstream_pa;
  row.cracked_length_m = stress.open_m;
}

/// Blocks that a panel in a crack lies between: its own, and the one that it touches there.
std::optional<std::pair<int, int>> pair_of(const scene::Scene& scene, const std::set<std::pair<int, int>>& touching,
                                           int block, const Point& middle, double near_m) {
  for (const auto& pair : touching) {
    if (pair.first != block && pair.second != block) continue;
    const auto& outline = scene.blocks[at(pair.first == block ? pair.second : pair.first)].vertices;
    for (std::size_t e = 0; e < outline.size(); ++e) {
      if (geometry::distance_to_segment(middle, outline[e], outline[(e + 1) % outline.size()]) <= near_m) return pair;
    }
  }
  return std::nullopt;
}

/// Half of what presses both faces of each surface apart: cracks are pressed alike on both.
std::vector<double> uplifts(const Solid& solid, const Surfaces& surfaces, const std::vector<SurfaceSum>& sums,
                            const wire::Load& water) {
  std::vector<double> uplift(sums.size(), 0);
  std::set<std::pair<int, int>> touching;
  for (const ContactPoint& c : solid.contacts()) touching.insert(c.pair());
  for (std::size_t i = water.cracks_from; i < water.block.size(); ++i) {
    const auto& outline = solid.scene().blocks[water.block[i]].vertices;
    const Point& a = outline[water.edge[i]];
    const Point span = outline[(water.edge[i] + 1) % outline.size()] - a;
    const Point middle = a + (water.s_from[i] + water.s_to[i]) / 2 * span;
    const auto pair =
        pair_of(solid.scene(), touching, static_cast<int>(water.block[i]), middle, 1e-6 * solid.model().size_m);
    if (!pair) continue;
    const Point force = (water.pressure_from_pa[i] + water.pressure_to_pa[i]) / 2 * (water.s_to[i] - water.s_from[i]) *
                        perpendicular(span);
    for (const int surface : surfaces.of(*pair)) {
      uplift[at(surface)] += std::abs(sums[at(surface)].across().dot(force)) / 2;
    }
  }
  return uplift;
}

/// From the crest down; of two at the same height the one upstream comes first.
void sort_downwards(std::vector<JointRow>& rows, double size_m) {
  const double same_m = 1e-6 * size_m;
  const auto place = [&](const JointRow& row) {
    return std::pair(-std::llround(row.downstream_end_m.y() / same_m), row.downstream_end_m.x());
  };
  std::stable_sort(rows.begin(), rows.end(), [&](const JointRow& a, const JointRow& b) { return place(a) < place(b); });
}

}  // namespace

std::vector<JointRow> joint_table(const Solid& solid, const wire::Load& water, const std::vector<WaterPart>& parts) {
  const Surfaces surfaces(solid);
  const std::vector<SurfaceSum> sums = surface_sums(solid, surfaces);
  const std::vector<double> uplift = uplifts(solid, surfaces, sums, water);
  const auto joints = surfaces.joints();
  std::vector<JointRow> rows;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const SurfaceSum& sum = sums[i];
    if (!sum.bears(surfaces.weights()[i])) continue;
    JointRow row{.name = surfaces.names()[i],
                 .length_m = sum.length_m(),
                 .normal_n_per_m = sum.normal_n_per_m(),
                 .shear_n_per_m = std::abs(sum.shear_n_per_m()),
                 .uplift_n_per_m = uplift[i]};
    if (sum.is_sheared() && !sum.is_buttressed()) {
      row.sliding_factor = sum.sliding_factor();
      row.residual_sliding_factor = sum.residual_sliding_factor();
    }
    row.bonded_length_m = sum.bonded_length_m();
    row.upstream_end_m = sum.upstream_end();
    row.downstream_end_m = sum.downstream_end();
    row.sums = force_sums(solid, water, parts, joints[i], row.downstream_end_m);
    const std::vector<FaceStretch> faces = faces_of(solid, joints[i], row);
    for (const FaceStretch& face : faces) row.faces_length_m += face.to_m - face.from_m;
    if (sum.is_pressed()) {
      const double r = sum.resultant_from_downstream();
      row.resultant_from_downstream = r;
      row.moment_n = row.normal_n_per_m * (0.5 - r) * row.length_m;
      add_stresses(faces, r, row);
    }
    rows.push_back(std::move(row));
  }
  sort_downwards(rows, solid.model().size_m);
  return rows;
}

std::vector<JointPart> joint_parts(const Solid& solid, const wire::Load& water, const std::vector<std::string>& names) {
  const Surfaces parts = Surfaces::parts(solid, names);
  const std::vector<SurfaceSum> sums = surface_sums(solid, parts);
  const std::vector<double> uplift = uplifts(solid, parts, sums, water);
  std::vector<JointPart> rows;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    rows.push_back({.name = parts.names()[i],
                    .length_m = sums[i].length_m(),
                    .normal_n_per_m = sums[i].normal_n_per_m(),
                    .shear_n_per_m = std::abs(sums[i].shear_n_per_m()),
                    .uplift_n_per_m = uplift[i],
                    .strength_n_per_m = sums[i].strength()});
  }
  return rows;
}

std::vector<JointRow> loads_on_joints(const Solid& solid, const wire::Load& water,
                                      const std::vector<WaterPart>& parts) {
  const Surfaces surfaces(solid);
  const std::vector<SurfaceSum> sums = surface_sums(solid, surfaces);
  const auto joints = surfaces.joints();
  std::vector<JointRow> rows;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    JointRow row{
        .name = surfaces.names()[i], .length_m = sums[i].length_m(), .downstream_end_m = sums[i].downstream_end()};
    row.sums = force_sums(solid, water, parts, joints[i], row.downstream_end_m);
    if (!row.sums.empty()) rows.push_back(std::move(row));
  }
  sort_downwards(rows, solid.model().size_m);
  return rows;
}

}  // namespace blockweir::solid
