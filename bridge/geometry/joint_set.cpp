// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/geometry/joint_set.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/uniform.hpp"

namespace blockweir::geometry {
std::vector<Line> joints_of(const JointSet& set, const Point& low, const Point& high, int id) {
  const double dip = set.dip_deg * std::numbers::pi / 180;
  const Point along(std::cos(dip), -std::sin(dip));
  const Point up(std::sin(dip), std::cos(dip));
  const Point middle = (low + high) / 2;
  const double radius = (high - low).norm() / 2;
  const double from = along.dot(middle) - radius;
  const double to = along.dot(middle) + radius;
  const double bridge = set.trace_length_m * (1 - set.persistence) / set.persistence;
  const bool bridged = set.persistence < 1;

  Uniform uniform(set.seed);
  std::vector<Line> lines;
  const double first = std::ceil((up.dot(middle) - radius - set.offset_m) / set.spacing_m - 1);
  const double last = std::floor((up.dot(middle) + radius - set.offset_m) / set.spacing_m + 1);
  for (int i = 0; i <= last - first; ++i) {  // first may be so large that first + 1 is the same number
    const double shift = set.spacing_deviation * (uniform() - 0.5);
    const double height = set.offset_m + (first + i + shift) * set.spacing_m;
    double start = bridged ? from - uniform() * (set.trace_length_m + bridge) : from;
    while (start < to) {
      const double end = bridged ? start + set.trace_length_m : to;
      if (end > from) lines.push_back({{height * up + start * along, height * up + end * along}, id});
      start = end + (bridged ? bridge : 1);
    }
  }
  return lines;
}

std::vector<Line> parts_within(const Line& line, std::span<const Point> outline, double beyond_m) {
  const Point& from = line.points.front();
  const Point along = (line.points.back() - from).normalized();
  const double length = (line.points.back() - from).norm();
  std::vector<double> crossings = {0, length};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double a = cross(along, outline[i] - from);
    const double b = cross(along, outline[(i + 1) % outline.size()] - from);
    if ((a > 0) == (b > 0)) continue;
    const Point at = outline[i] + a / (a - b) * (outline[(i + 1) % outline.size()] - outline[i]);
    crossings.push_back(std::clamp(along.dot(at - from), 0.0, length));
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Line> parts;
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    if (crossings[i] - crossings[i - 1] <= beyond_m) continue;
    if (!holds_point(outline, from + (crossings[i - 1] + crossings[i]) / 2 * along, 0)) continue;
    parts.push_back(
        {{from + (crossings[i - 1] - beyond_m) * along, from + (crossings[i] + beyond_m) * along}, line.id});
  }
  return parts;
}

}  // namespace blockweir::geometry
