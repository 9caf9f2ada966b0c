// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/linear_stress.hpp"

#include <algorithm>
#include <utility>

namespace blockweir::solid {
namespace {

/// Integrals of 1, x and x^2 over stretches.
struct Moments {
  double zeroth = 0;
  double first = 0;
  double second = 0;
};

/// Over what lies beyond x0.
Moments moments(const std::vector<FaceStretch>& faces, double x0) {
  Moments sum;
  for (const FaceStretch& face : faces) {
    if (face.to_m <= x0) continue;
    const double a = std::max(face.from_m, x0);
    const double b = face.to_m;
    sum.zeroth += b - a;
    sum.first += (b * b - a * a) / 2;
    sum.second += (b * b * b - a * a * a) / 3;
  }
  return sum;
}

/// Force of the stress x - x0 beyond x0, and where its resultant is.
std::pair<double, double> wedge(const std::vector<FaceStretch>& faces, double x0) {
  const Moments m = moments(faces, x0);
  const double force = m.first - x0 * m.zeroth;
  return {force, (m.second - x0 * m.first) / force};
}

/// The upstream end open.
LinearStress pressed_downstream(const std::vector<FaceStretch>& faces, double normal_n_per_m, double resultant_m) {
  constexpr int halvings = 60;
  double low = faces.front().from_m;
  double high = std::min(faces.back().to_m, resultant_m);
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (wedge(faces, middle).second < resultant_m ? low : high) = middle;
  }
  const double all_m = moments(faces, faces.front().from_m).zeroth;
  return {0, normal_n_per_m / wedge(faces, low).first * (faces.back().to_m - low), all_m - moments(faces, low).zeroth};
}

/// Seen from the downstream end.
std::vector<FaceStretch> mirrored(const std::vector<FaceStretch>& faces) {
  std::vector<FaceStretch> seen;
  for (auto face = faces.rbegin(); face != faces.rend(); ++face) seen.push_back({-face->to_m, -face->from_m});
  return seen;
}

}  // namespace

std::vector<FaceStretch> joined(std::vector<FaceStretch> stretches, double near_m) {
  std::sort(stretches.begin(), stretches.end(),
            [](const FaceStretch& a, const FaceStretch& b) { return a.from_m < b.from_m; });
  std::vector<FaceStretch> all;
  for (const FaceStretch& s : stretches) {
    if (!all.empty() && s.from_m <= all.back().to_m + near_m) {
      all.back().to_m = std::max(all.back().to_m, s.to_m);
    } else {
      all.push_back(s);
    }
  }
  return all;
}

LinearStress linear_stress(const std::vector<FaceStretch>& faces, double normal_n_per_m, double resultant_m) {
  const double upstream = faces.front().from_m;
  const double downstream = faces.back().to_m;
  const Moments m = moments(faces, upstream);
  if (resultant_m <= upstream || resultant_m >= downstream) return {0, 0, m.zeroth};
  const double centre = m.first / m.zeroth;
  const double inertia = m.second - centre * m.first;
  const auto stress = [&](double x) {
    return normal_n_per_m * (1 / m.zeroth + (resultant_m - centre) * (x - centre) / inertia);
  };
  if (stress(upstream) >= 0 && stress(downstream) >= 0) return {stress(upstream), stress(downstream), 0};
  if (stress(upstream) < 0) return pressed_downstream(faces, normal_n_per_m, resultant_m);
  const LinearStress seen = pressed_downstream(mirrored(faces), normal_n_per_m, -resultant_m);
  return {seen.downstream_pa, seen.upstream_pa, seen.open_m};
}

}  // namespace blockweir::solid
