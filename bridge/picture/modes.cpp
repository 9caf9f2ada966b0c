// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/modes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/geometry/outline.hpp"
#include "bridge/picture/draw.hpp"
#include "bridge/picture/gnuplot.hpp"

namespace blockweir::picture {
namespace {

using geometry::Bounds;
using nlohmann::json;
using scene::Point;

constexpr std::size_t most_pictures = 6;
constexpr double swing_ratio = 0.05;  // largest displacement over the structure's size

struct Outline {
  std::vector<Point> at_rest;
  std::vector<Point> displacement;
};

std::vector<Outline> outlines_of(const json& mode) {
  std::vector<Outline> outlines;
  for (const json& block : mode["shape"]) {
    Outline& outline = outlines.emplace_back();
    for (const json& p : block["points_m"]) {
      outline.at_rest.emplace_back(p[0].get<double>(), p[1].get<double>());
      outline.displacement.emplace_back(p[2].get<double>(), p[3].get<double>());
    }
  }
  return outlines;
}

/// The box around what can move, with room for its swing.
Bounds view_of_swing(const std::vector<Outline>& outlines) {
  std::vector<Point> all;
  for (const Outline& o : outlines) all.insert(all.end(), o.at_rest.begin(), o.at_rest.end());
  Bounds view = geometry::bounds_of(all);
  const Point margin = Point::Constant(0.25 * view.size());
  return {view.low - margin, view.high + margin};
}

std::string drawn(const scene::Scene& scene, const json& mode, std::size_t number, const Bounds& view) {
  const std::vector<Outline> outlines = outlines_of(mode);
  double largest = 0;
  for (const Outline& o : outlines) {
    for (const Point& u : o.displacement) largest = std::max(largest, u.norm());
  }
  const double by = largest > 0 ? swing_ratio * (view.high - view.low).norm() / largest : 0;
  const json& period = mode["period_s"];
  std::string script =
      fmt::format("unset object\nset title '{}: {}'\n", number,
                  period.is_null() ? "free"
                                   : fmt::format("{:.4g} rad/s, {:.4g} Hz", mode["omega_rad_per_s"].get<double>(),
                                                 mode["frequency_hz"].get<double>()));
  int object = 0;
  const View seen = view_of(view);
  for (const scene::Block& block : scene.blocks) {
    if (!block.fixed) continue;
    script +=
        gnuplot_polygon(object, block.vertices, seen, "fc rgb '#8d7f6d' fillstyle solid border lc rgb '#303030' lw 1");
  }
  for (const Outline& o : outlines) {
    std::vector<Point> moved;
    for (std::size_t i = 0; i < o.at_rest.size(); ++i) moved.push_back(o.at_rest[i] + by * o.displacement[i]);
    script += gnuplot_polygon(object, moved, seen, "fc rgb '#8fb0c9' fillstyle solid 0.8 border lc rgb '#303030' lw 1");
    script += gnuplot_polygon(object, o.at_rest, seen, "fs empty border lc rgb '#303030' lw 1 dt 2 front");
  }
  return script + "plot NaN notitle\n";
}

}  // namespace

void draw_modes(const scene::Scene& scene, const json& answer, const std::filesystem::path& out) {
  const json& modes = answer.contains("wet") ? answer["wet"] : answer["dry"];
  const std::size_t count = std::min(most_pictures, modes.size());
  const Bounds view = view_of_swing(outlines_of(modes[0]));
  const Point span = view.high - view.low;
  const double aspect = std::clamp(span.y() / span.x(), 0.5, 2.0);
  const std::size_t columns = std::min<std::size_t>(3, count);
  const std::size_t rows = (count + columns - 1) / columns;
  std::string script = fmt::format(
      "set multiplot layout {},{} title {}\n"
      "set size ratio -1\nunset key\nset tics out nomirror\nset xlabel 'x (m)'\nset ylabel 'elevation (m)'\n"
      "set xrange [{}:{}]\nset yrange [{}:{}]\n",
      rows, columns, gnuplot_text(answer.contains("wet") ? "natural modes, with the water's inertia" : "natural modes"),
      view.low.x(), view.high.x(), view.low.y(), view.high.y());
  for (std::size_t k = 0; k < count; ++k) script += drawn(scene, modes[k], k + 1, view);
  const double height = 40 + static_cast<double>(rows) * (80 + 290 * aspect);
  draw({{out, 360.0 * static_cast<double>(columns), height, script + "unset multiplot\n", 10}});
}

}  // namespace blockweir::picture
