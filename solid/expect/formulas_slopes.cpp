// SPDX-License-Identifier: GPL-3.0-or-later
// Limit equilibrium of columns that topple down a slope of treads (Goodman and Bray 1976).
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "bridge/geometry/polygon.hpp"
#include "solid/expect/formula_tables.hpp"

namespace blockweir::solid::expect {
namespace {

/// A rectangular block on a tread along x, down which gravity is tilted.
struct Column {
  double weight = 0;
  double right = 0;  ///< its downhill face
  double breadth = 0;
  double base = 0;
  double top = 0;
};

/// From the upper end of the slope to its toe.
std::vector<Column> columns(const Scene& s) {
  std::vector<Column> all;
  for (const scene::Block& block : s.blocks) {
    if (block.fixed) continue;
    Eigen::AlignedBox2d box;
    for (const Point& v : block.vertices) box.extend(v);
    if (std::abs(geometry::signed_area(block.vertices) / box.volume() - 1) > 1e-9) {
      throw std::runtime_error("toppling-slope-friction is for rectangles along the axes, not for \"" + block.name +
                               "\"; draw it as one, or state a value in place of the formula");
    }
    all.push_back({weight(s, block), box.max().x(), box.sizes().x(), box.min().y(), box.max().y()});
  }
  std::sort(all.begin(), all.end(), [](const Column& a, const Column& b) { return a.right < b.right; });
  return all;
}

/// Force needed at the top of the lowest column [N per metre], negative if the slope is stable; t = tan(friction) on
/// bases and sides. A column of height y and breadth B, pushed by P at the height M, pushes the next one at the height
/// L with the larger of the forces against toppling and against sliding, friction on its sides being at its limit:
///   (P (M - B t) + W (y sin a - B cos a)/2)/L   and   P - W (t cos a - sin a)/(1 - t^2).
///
double force_at_toe(const std::vector<Column>& slope, double tilt, double t) {
  double push = 0;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    const Column& c = slope[i];
    const bool toe = i + 1 == slope.size();
    const double above = i == 0 ? 0 : std::min(c.top, slope[i - 1].top) - c.base;
    const double below = toe ? c.top - c.base : std::min(c.top, slope[i + 1].top) - c.base;
    const double moment = c.weight / 2 * ((c.top - c.base) * std::sin(tilt) - c.breadth * std::cos(tilt));
    const double topples = (push * (above - c.breadth * t) + moment) / below;
    const double slides = push - c.weight * (t * std::cos(tilt) - std::sin(tilt)) / (1 - t * t);
    push = toe ? std::max(topples, slides) : std::max({0.0, topples, slides});
  }
  return push;
}

/// The angle at which the toe needs no force [deg]. Throws std::runtime_error where none below 45 degrees holds.
double toppling_slope_friction(const Scene& s, const std::string&) {
  const std::vector<Column> slope = columns(s);
  const double tilt = s.analysis.gravity_tilt_deg * std::numbers::pi / 180;
  double moves = 0;
  double stands = 1 - 1e-9;
  if (force_at_toe(slope, tilt, stands) >= 0) {
    throw std::runtime_error(
        "toppling-slope-friction: no friction below 45 degrees holds the slope; expected one that does; lower "
        "gravity_tilt_deg or the columns");
  }
  for (int i = 0; i < 50; ++i) {
    const double t = (moves + stands) / 2;
    (force_at_toe(slope, tilt, t) < 0 ? stands : moves) = t;
  }
  return std::atan(stands) * 180 / std::numbers::pi;
}

}  // namespace

const Formulas& slope_formulas() {
  static const Formulas all = {{"toppling-slope-friction", toppling_slope_friction}};
  return all;
}

}  // namespace blockweir::solid::expect
