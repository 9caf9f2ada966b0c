// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/mechanism.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/picture/draw.hpp"
#include "bridge/picture/gnuplot.hpp"
#include "bridge/picture/pictured_structure.hpp"
#include "bridge/scene/block_facts.hpp"

namespace blockweir::picture {
namespace {

using geometry::Bounds;
using nlohmann::json;
using scene::Point;

constexpr double drawn_ratio = 0.06;  // displacement of the fastest vertex, over the structure's size

/// Velocity x and y of the centroid and spin, by the block's name.
std::map<std::string, Eigen::Vector3d> motions_of(const json& mechanism) {
  std::map<std::string, Eigen::Vector3d> motions;
  for (const json& block : mechanism["blocks"]) {
    motions[block["name"]] = Eigen::Vector3d(block["velocity_x"].get<double>(), block["velocity_y"].get<double>(),
                                             block["spin_per_m"].get<double>());
  }
  return motions;
}

/// Turned by the exact angle, so that what is drawn keeps its shape.
std::vector<Point> displaced(const std::vector<Point>& outline, const Eigen::Vector3d& motion, double by) {
  const Point centre = geometry::centroid(outline);
  const Eigen::Rotation2Dd turn(by * motion.z());
  std::vector<Point> moved;
  for (const Point& p : outline) moved.push_back(centre + by * motion.head<2>() + turn * (p - centre));
  return moved;
}

std::string reservoir(const Bounds& view, const scene::Scene& scene, double level_m) {
  const double face = pictured_structure(scene).low.x();
  return fmt::format(
      "set arrow from {},{} to {},{} nohead lc rgb '#1f6fb4' lw 2 front\n"
      "set label '{:.6g} m' at {},{} offset 0.5,0.6 tc rgb '#1f6fb4' front\n",
      view.low.x(), level_m, face, level_m, level_m, view.low.x(), level_m);
}

}  // namespace

std::string mechanism_title(const json& mechanism) {
  const std::string title = gnuplot_title(mechanism["text"], 900);
  const std::string caption = mechanism.value("caption", "");
  return caption.empty() ? title : title + ".\"\\n\"." + gnuplot_text(caption);
}

Bounds mechanism_view(const scene::Scene& scene, const json& mechanism) {
  const std::map<std::string, Eigen::Vector3d> motions = motions_of(mechanism);
  const Bounds structure = pictured_structure(scene);
  std::vector<Point> shown{structure.low, structure.high};
  for (const scene::Block& block : scene.blocks) {
    if (motions.contains(block.name)) shown.insert(shown.end(), block.vertices.begin(), block.vertices.end());
  }
  const Bounds view = geometry::bounds_of(shown);
  const Point margin = Point::Constant(view.size() / 3);
  return {view.low - margin, view.high + margin};
}

void draw_mechanism(const scene::Scene& scene, const json& mechanism, const std::optional<double>& level_m,
                    const std::filesystem::path& out) {
  const Bounds view = mechanism_view(scene, mechanism);
  const Point span = view.high - view.low;
  const double aspect = std::clamp(span.y() / span.x(), 0.3, 2.0);
  std::string script = fmt::format(
      "set title {}\nset size ratio -1\n"
      "unset key\nset tics out nomirror\nset xlabel 'x (m)'\nset ylabel 'elevation (m)'\nset xrange [{}:{}]\n"
      "set yrange [{}:{}]\n",
      mechanism_title(mechanism), view.low.x(), view.high.x(), view.low.y(), view.high.y());
  const std::map<std::string, Eigen::Vector3d> motions = motions_of(mechanism);
  const double by = drawn_ratio * pictured_structure(scene).size();
  const View seen = view_of(view);
  int number = 0;
  for (const scene::Block& block : scene.blocks) {
    if (motions.contains(block.name)) continue;
    script += gnuplot_polygon(
        number, block.vertices, seen,
        fmt::format("fc rgb '{}' fillstyle solid border lc rgb '#303030' lw 1", block.fixed ? "#8d7f6d" : "#c9c9c4"));
  }
  for (const scene::Block& block : scene.blocks) {
    const auto motion = motions.find(block.name);
    if (motion == motions.end()) continue;
    script += gnuplot_polygon(number, displaced(block.vertices, motion->second, by), seen,
                              "fc rgb '#d98c5f' fillstyle solid 0.8 border lc rgb '#303030' lw 1");
    script += gnuplot_polygon(number, block.vertices, seen, "fs empty border lc rgb '#303030' lw 1 dt 2 front");
  }
  if (level_m) script += reservoir(view, scene, *level_m);
  draw({{out, 900, 100 + 800 * aspect, script + "plot NaN notitle\n", 11}});
}

}  // namespace blockweir::picture
