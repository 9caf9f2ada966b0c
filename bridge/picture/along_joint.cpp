// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/along_joint.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::picture {
namespace {

using Part = std::vector<JointPoint>;

/// Parts that touch as listed stay together.
std::vector<Part> parts_of(const std::vector<JointPoint>& points, double near_m) {
  std::vector<Part> parts;
  std::size_t first = 0;  // of the points of the present part of the table
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto way = [&](std::size_t k) -> Eigen::Vector2d { return points[k].at_m - points[k - 1].at_m; };
    const bool evenly = i < first + 2 || (way(i) - way(i - 1)).norm() <= near_m;
    if (i == 0 || !evenly) {
      first = i;
      if (i == 0 || way(i).norm() > near_m) parts.emplace_back();
    }
    parts.back().push_back(points[i]);
  }
  return parts;
}

double least_distance(const Eigen::Vector2d& from, const Part& part) {
  return std::min((part.front().at_m - from).norm(), (part.back().at_m - from).norm());
}

/// Where no other part goes on.
bool is_end(const Eigen::Vector2d& place, std::size_t own, const std::vector<Part>& parts, double near_m) {
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (p != own && least_distance(place, parts[p]) <= near_m) return false;
  }
  return true;
}

Eigen::Vector2d upstream_end(const std::vector<Part>& parts, double near_m) {
  std::vector<Eigen::Vector2d> ends;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const JointPoint& end : {parts[p].front(), parts[p].back()}) {
      if (is_end(end.at_m, p, parts, near_m)) ends.push_back(end.at_m);
    }
  }
  if (ends.empty()) return parts.front().front().at_m;  // it goes round a block
  return *std::min_element(ends.begin(), ends.end(), [near_m](const auto& a, const auto& b) {
    return std::abs(a.x() - b.x()) > near_m ? a.x() < b.x() : a.y() > b.y();
  });
}

}  // namespace

std::vector<AlongJoint> along_joint(const std::vector<JointPoint>& points) {
  if (points.empty()) return {};
  constexpr double opened = 1e-3;  // of the joint: by so much its parts may have come apart
  Eigen::Vector2d low = points.front().at_m;
  Eigen::Vector2d high = low;
  for (const JointPoint& p : points) low = low.cwiseMin(p.at_m), high = high.cwiseMax(p.at_m);
  const double near_m = opened * (high - low).norm();
  std::vector<Part> parts = parts_of(points, near_m);
  Eigen::Vector2d here = upstream_end(parts, near_m);
  double way_m = 0;
  std::vector<AlongJoint> along;
  while (!parts.empty()) {
    const auto next = std::min_element(parts.begin(), parts.end(), [&](const Part& a, const Part& b) {
      return least_distance(here, a) < least_distance(here, b);
    });
    if ((next->back().at_m - here).norm() < (next->front().at_m - here).norm())
      std::reverse(next->begin(), next->end());
    for (const JointPoint& p : *next) {
      way_m += (p.at_m - here).norm();
      here = p.at_m;
      along.push_back({way_m, p.value});
    }
    parts.erase(next);
  }
  return along;
}

}  // namespace blockweir::picture
