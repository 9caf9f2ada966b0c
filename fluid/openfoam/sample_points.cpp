// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/sample_points.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::openfoam {
namespace {

constexpr int near_samples = 4;  // an open cell within two cells is near enough

Point along_axis(const Point& normal) {
  return std::abs(normal.x()) >= std::abs(normal.y()) ? Point(std::copysign(1, normal.x()), 0)
                                                      : Point(0, std::copysign(1, normal.y()));
}

/// `first`, the normal, and the diagonals beside them that lead outwards.
std::vector<Point> directions(const Point& first, const Point& normal) {
  constexpr double outwards = 0.1;
  std::vector<Point> all{first, normal};
  for (const Point& way : {along_axis(normal), normal}) {
    const Point side(-way.y(), way.x());
    for (const double sign : {1.0, -1.0}) {
      const Point diagonal = (way + sign * side).normalized();
      if (diagonal.dot(normal) > outwards) all.push_back(diagonal);
    }
  }
  return all;
}

/// As far as the ray sees along one direction.
SamplePoints sample_along(const SampleRay& ray, const Point& direction, const Faces& faces, double cell_m) {
  const double far = 0.5 * SamplePoints::most * cell_m;
  // A mouth lies on edges itself.
  const double off = ray.block < 0 ? 1e-6 * cell_m : 0;
  const double sight = off + faces.nearest(ray.from + off * direction, direction, far, ray.block, ray.edge).distance_m;
  SamplePoints samples;
  while (samples.count < SamplePoints::most && 0.5 * (samples.count + 1) * cell_m < sight) {
    samples.at[static_cast<std::size_t>(samples.count)] = ray.from + 0.5 * (samples.count + 1) * cell_m * direction;
    ++samples.count;
  }
  if (samples.count > 0) return samples;
  samples.at[0] = ray.from + 0.5 * sight * direction;
  samples.count = 1;
  return samples;
}

/// Fills of the cells at all points of all sample points, row by row.
std::vector<double> fills_of(const std::vector<SamplePoints>& all, const Fills& fills) {
  std::vector<Point> points;
  for (const SamplePoints& samples : all)
    points.insert(points.end(), samples.at.begin(), samples.at.begin() + samples.count);
  return fills(points);
}

int first_open(const double* fills, int count) {
  int first = 0;
  while (first < count && fills[first] > untouched) ++first;
  return first < count ? first : SamplePoints::most;
}

/// The nearest open cell of all directions, or else the cell that is filled least.
SamplePoints best_of(const std::vector<SamplePoints>& all, const double* fills) {
  constexpr double clearly = 0.01;
  const SamplePoints* best = nullptr;
  int nearest = SamplePoints::most;
  SamplePoints cut;
  cut.cut = true;
  double least = sealed;
  for (const SamplePoints& samples : all) {
    const int first = first_open(fills, samples.count);
    if (first < nearest) {
      nearest = first;
      best = &samples;
    }
    for (int k = 0; k < samples.count; ++k) {
      if (fills[k] >= (cut.count == 0 ? least : least - clearly)) continue;
      least = fills[k];
      cut.at[0] = samples.at[static_cast<std::size_t>(k)];
      cut.count = 1;
    }
    fills += samples.count;
  }
  return best != nullptr ? *best : cut;
}

}  // namespace

SampleRay ray_of(const EdgeElement& element) {
  return {element.middle(), directions(along_axis(element.normal), element.normal), element.block, element.edge};
}

SampleRay ray_at(const Point& mouth, const Point& direction) {
  return {mouth, directions(direction, direction), -1, -1};
}

std::vector<SamplePoints> find_sample_points(const std::vector<SampleRay>& rays, const Faces& faces, double cell_m,
                                             const Fills& fills) {
  std::vector<SamplePoints> samples;
  samples.reserve(rays.size());
  for (const SampleRay& ray : rays) samples.push_back(sample_along(ray, ray.directions.front(), faces, cell_m));
  const std::vector<double> straight = fills_of(samples, fills);
  const double* row = straight.data();
  std::vector<std::size_t> blocked;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (first_open(row, samples[i].count) >= near_samples) blocked.push_back(i);
    row += samples[i].count;
  }
  std::vector<SamplePoints> others;
  for (const std::size_t i : blocked) {
    for (const Point& direction : rays[i].directions) {
      others.push_back(sample_along(rays[i], direction, faces, cell_m));
    }
  }
  const std::vector<double> sideways = fills_of(others, fills);
  row = sideways.data();
  auto next = others.begin();
  for (const std::size_t i : blocked) {
    const auto end = next + static_cast<std::ptrdiff_t>(rays[i].directions.size());
    const std::vector<SamplePoints> all(next, end);
    samples[i] = best_of(all, row);
    for (; next != end; ++next) row += next->count;
  }
  return samples;
}

Targets find_targets(const Faces& faces, const ElementRules& rules, const std::vector<SampleRay>& openings,
                     const Fills& fills) {
  Targets t;
  t.elements = edge_elements(faces, rules);
  std::vector<SampleRay> rays;
  for (const EdgeElement& e : t.elements) {
    t.samples_of.push_back(e.openness > 0 ? rays.size() : Targets::none);
    if (e.openness > 0) rays.push_back(ray_of(e));
  }
  t.openings_from = rays.size();
  rays.insert(rays.end(), openings.begin(), openings.end());
  t.mouths.resize(t.elements.size());
  for (std::size_t i = 0; i < t.elements.size(); ++i) {
    if (!t.elements[i].slot) continue;
    for (const SlotMouth& mouth : slot_mouths(t.elements[i], faces, rules.cell_m)) {
      t.mouths[i].push_back({rays.size(), mouth});
      rays.push_back(ray_at(mouth.point, mouth.direction));
    }
  }
  t.samples = find_sample_points(rays, faces, rules.cell_m, fills);
  for (std::vector<Mouth>& mouths : t.mouths) {
    const auto leads_nowhere = [&](const Mouth& m) { return t.samples[m.samples].cut; };
    mouths.erase(std::remove_if(mouths.begin(), mouths.end(), leads_nowhere), mouths.end());
  }
  return t;
}

}  // namespace blockweir::openfoam
