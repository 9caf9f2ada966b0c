// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/looks.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::openfoam {
namespace {

constexpr int near_looks = 4;  // an open cell within two cells is near enough

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

/// As far as the seeker sees along one direction.
Looks look_along(const Seeker& seeker, const Point& direction, const Faces& faces, double cell_m) {
  const double far = 0.5 * Looks::most * cell_m;
  // A mouth lies on edges itself.
  const double off = seeker.block < 0 ? 1e-6 * cell_m : 0;
  const double sight =
      off + faces.nearest(seeker.from + off * direction, direction, far, seeker.block, seeker.edge).distance_m;
  Looks looks;
  while (looks.count < Looks::most && 0.5 * (looks.count + 1) * cell_m < sight) {
    looks.at[static_cast<std::size_t>(looks.count)] = seeker.from + 0.5 * (looks.count + 1) * cell_m * direction;
    ++looks.count;
  }
  if (looks.count > 0) return looks;
  looks.at[0] = seeker.from + 0.5 * sight * direction;
  looks.count = 1;
  return looks;
}

/// Fills of the cells at all points of all looks, row by row.
std::vector<double> fills_of(const std::vector<Looks>& all, const Fills& fills) {
  std::vector<Point> points;
  for (const Looks& looks : all) points.insert(points.end(), looks.at.begin(), looks.at.begin() + looks.count);
  return fills(points);
}

int first_open(const double* fills, int count) {
  int first = 0;
  while (first < count && fills[first] > untouched) ++first;
  return first < count ? first : Looks::most;
}

/// The nearest open cell of all directions, or else the cell that is filled least.
Looks best_of(const std::vector<Looks>& all, const double* fills) {
  constexpr double clearly = 0.01;
  const Looks* best = nullptr;
  int nearest = Looks::most;
  Looks cut;
  cut.cut = true;
  double least = sealed;
  for (const Looks& looks : all) {
    const int first = first_open(fills, looks.count);
    if (first < nearest) {
      nearest = first;
      best = &looks;
    }
    for (int k = 0; k < looks.count; ++k) {
      if (fills[k] >= (cut.count == 0 ? least : least - clearly)) continue;
      least = fills[k];
      cut.at[0] = looks.at[static_cast<std::size_t>(k)];
      cut.count = 1;
    }
    fills += looks.count;
  }
  return best != nullptr ? *best : cut;
}

}  // namespace

Seeker seeker_of(const EdgeElement& element) {
  return {element.middle(), directions(along_axis(element.normal), element.normal), element.block, element.edge};
}

Seeker seeker_at(const Point& mouth, const Point& direction) {
  return {mouth, directions(direction, direction), -1, -1};
}

std::vector<Looks> aim(const std::vector<Seeker>& seekers, const Faces& faces, double cell_m, const Fills& fills) {
  std::vector<Looks> looks;
  looks.reserve(seekers.size());
  for (const Seeker& seeker : seekers) looks.push_back(look_along(seeker, seeker.directions.front(), faces, cell_m));
  const std::vector<double> straight = fills_of(looks, fills);
  const double* row = straight.data();
  std::vector<std::size_t> blocked;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    if (first_open(row, looks[i].count) >= near_looks) blocked.push_back(i);
    row += looks[i].count;
  }
  std::vector<Looks> others;
  for (const std::size_t i : blocked) {
    for (const Point& direction : seekers[i].directions) {
      others.push_back(look_along(seekers[i], direction, faces, cell_m));
    }
  }
  const std::vector<double> sideways = fills_of(others, fills);
  row = sideways.data();
  auto next = others.begin();
  for (const std::size_t i : blocked) {
    const auto end = next + static_cast<std::ptrdiff_t>(seekers[i].directions.size());
    const std::vector<Looks> all(next, end);
    looks[i] = best_of(all, row);
    for (; next != end; ++next) row += next->count;
  }
  return looks;
}

Targets find_targets(const Faces& faces, const ElementRules& rules, const std::vector<Seeker>& openings,
                     const Fills& fills) {
  Targets t;
  t.elements = edge_elements(faces, rules);
  std::vector<Seeker> seekers;
  for (const EdgeElement& e : t.elements) {
    t.looks_of.push_back(e.openness > 0 ? seekers.size() : Targets::none);
    if (e.openness > 0) seekers.push_back(seeker_of(e));
  }
  t.openings_from = seekers.size();
  seekers.insert(seekers.end(), openings.begin(), openings.end());
  t.mouths.resize(t.elements.size());
  for (std::size_t i = 0; i < t.elements.size(); ++i) {
    if (!t.elements[i].slot) continue;
    for (const SlotMouth& mouth : slot_mouths(t.elements[i], faces, rules.cell_m)) {
      t.mouths[i].push_back({seekers.size(), mouth});
      seekers.push_back(seeker_at(mouth.point, mouth.direction));
    }
  }
  t.looks = aim(seekers, faces, rules.cell_m, fills);
  for (std::vector<Mouth>& mouths : t.mouths) {
    const auto leads_nowhere = [&](const Mouth& m) { return t.looks[m.looks].cut; };
    mouths.erase(std::remove_if(mouths.begin(), mouths.end(), leads_nowhere), mouths.end());
  }
  return t;
}

}  // namespace blockweir::openfoam
