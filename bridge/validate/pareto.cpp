// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/validate/pareto.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace blockweir::study {
namespace {

constexpr double clearly = 1.1;  // wall times of equal runs differ by some per cent

double seen(double error) {
  return std::max(error, round_off);
}

}  // namespace

bool betters(const Point& a, const Point& b) {
  const bool faster = a.time_s * clearly < b.time_s && seen(a.error) <= seen(b.error);
  const bool more_accurate = a.time_s <= b.time_s && seen(a.error) * clearly < seen(b.error);
  return faster || more_accurate;
}

std::vector<std::size_t> front(const std::vector<Point>& points) {
  std::vector<std::size_t> by_time(points.size());
  std::iota(by_time.begin(), by_time.end(), std::size_t{0});
  std::sort(by_time.begin(), by_time.end(), [&](std::size_t i, std::size_t j) {
    return points[i].time_s != points[j].time_s ? points[i].time_s < points[j].time_s
                                                : points[i].error < points[j].error;
  });
  std::vector<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : by_time) {
    if (seen(points[i].error) >= least) continue;
    least = seen(points[i].error);
    best.push_back(i);
  }
  return best;
}

}  // namespace blockweir::study
