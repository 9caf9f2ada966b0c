// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/plot_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/picture/frames.hpp"
#include "bridge/picture/gnuplot.hpp"
#include "bridge/picture/report_section.hpp"
#include "bridge/process/programs.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::picture {
namespace {

using nlohmann::json;
using Point = Eigen::Vector2d;

Point point_of(const json& pair) {
  return {pair[0].get<double>(), pair[1].get<double>()};
}

/// An arrow that ends where the load acts, with its size in kN a metre of thickness, or kPa.
std::string arrow(const Point& at, const Point& force, double length_m, const std::string& size) {
  if (force.norm() == 0) return "";
  const Point from = at - length_m * force.normalized();
  return fmt::format(
      "set arrow from {},{} to {},{} filled lw 2 lc rgb '#7a1fa2' front\nset label {} at {},{} {} tc rgb '#7a1fa2' "
      "front\n",
      from.x(), from.y(), at.x(), at.y(), gnuplot_text(size), from.x(), from.y(), force.x() > 0 ? "right" : "left");
}

std::string loads(const json& data, double length_m) {
  std::string text;
  for (const json& load : data["loads"]) {
    if (load["kind"] == "point") {
      const Point force = point_of(load["force"]);
      text += arrow(point_of(load["at"]), force, length_m, fmt::format("{:.4g} kN/m", force.norm() / 1e3));
      continue;
    }
    constexpr int parts = 4;
    for (int i = 0; i <= parts; ++i) {
      const double s = static_cast<double>(i) / parts;
      const auto between = [&](const char* a, const char* b) -> Point {
        return (1 - s) * point_of(load[a]) + s * point_of(load[b]);
      };
      const Point force = between("force_from", "force_to");
      const bool named = i == 0 || i == parts;
      text += arrow(between("from", "to"), force, length_m, named ? fmt::format("{:.4g} kPa", force.norm() / 1e3) : "");
    }
  }
  return text;
}

std::string joints(const json& data) {
  std::string text;
  for (const json& joint : data["joints"]) {
    const json& line = joint["lines"][0];
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      text += fmt::format("set arrow from {},{} to {},{} nohead dt 2 lw 2 lc rgb '#b3261e' front\n",
                          line[i][0].get<double>(), line[i][1].get<double>(), line[i + 1][0].get<double>(),
                          line[i + 1][1].get<double>());
    }
    if (!joint["labelled"].get<bool>()) continue;
    const Point middle = (point_of(line.front()) + point_of(line.back())) / 2;
    text += fmt::format("set label {} at {},{} center offset 0,0.7 tc rgb '#b3261e' front\n",
                        gnuplot_text(joint["name"].get<std::string>()), middle.x(), middle.y());
  }
  return text;
}

}  // namespace

std::string section_script(const std::filesystem::path& run, const std::string& terminal, const std::string& ending) {
  const scene::Scene scene = scene::read(process::scene_of(run)).scene;
  const json data = section_data(scene);
  const View view = view_of({read_frames(run).front()}, 1e300);
  const double aspect = std::clamp((view.top - view.bottom) / (view.right - view.left), 0.3, 2.0);
  std::string script = fmt::format(
      "reset\nset size ratio -1\nunset key\nset tics out nomirror\nset xlabel 'x [m]'\nset ylabel 'y [m]'\n"
      "set terminal {} size 1000,{:.0f}\nset output {}\nset title {}\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
      terminal, 80 + 940 * aspect, gnuplot_path(run / ("section" + ending)), gnuplot_text(scene.title), view.left,
      view.right, view.bottom, view.top);
  int number = 0;
  for (const json& block : data["blocks"]) {
    std::vector<Point> outline;
    for (const json& p : block["outline"]) {
      outline.emplace_back(std::clamp(p[0].get<double>(), view.left, view.right),
                           std::clamp(p[1].get<double>(), view.bottom, view.top));
    }
    script += gnuplot_polygon(++number, outline,
                              fmt::format("fc rgb '{}' fillstyle solid border lc rgb '#303030' lw 1",
                                          block["fixed"].get<bool>() ? "#8d7f6d" : "#c9c9c4"));
  }
  return script + joints(data) + loads(data, 0.08 * (view.right - view.left)) + "plot NaN notitle\n";
}

}  // namespace blockweir::picture
