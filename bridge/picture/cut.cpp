// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/cut.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/picture/draw.hpp"
#include "bridge/picture/gnuplot.hpp"
#include "bridge/picture/view_grid.hpp"
#include "bridge/results/counted.hpp"
#include "bridge/results/folder.hpp"
#include "bridge/results/wrapped.hpp"
#include "bridge/scene/block_facts.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/read/read.hpp"
#include "bridge/scene/structure_size.hpp"
#include "bridge/scene/touching_pairs.hpp"

namespace blockweir::picture {
namespace {

std::string style_of(const scene::Block& block) {
  constexpr const char* colours[] = {"#c9c9c4", "#d9c8a9", "#b7c7b0", "#c6b7cc", "#b5c4d4", "#dcbdb2"};
  return fmt::format("fc rgb '{}' fillstyle solid border lc rgb '#303030' lw 1",
                     block.fixed ? "#8d7f6d" : colours[static_cast<std::size_t>(block.material) % std::size(colours)]);
}

constexpr double picture_width = 1200;  // pixels
constexpr double frame_width = 1080;

/// What can move with some ground around it, up to twice its size; all blocks of a scene in which nothing moves.
View view_of_structure(const scene::Scene& scene) {
  const geometry::Bounds all = scene::bounds_of(scene);
  View structure;
  for (const scene::Block& block : scene.blocks) {
    if (block.fixed) continue;
    for (const scene::Point& p : block.vertices) structure.include(p.x(), p.y());
  }
  if (structure.left > structure.right) structure = view_of(all);
  const double aside = std::max(structure.right - structure.left, structure.top - structure.bottom) / 2;
  const double edge = 0.06 * aside;
  return {std::max(structure.left - aside, all.low.x() - edge), std::min(structure.right + aside, all.high.x() + edge),
          std::max(structure.bottom - aside, all.low.y() - edge), std::min(structure.top + aside, all.high.y() + edge)};
}

/// The names that fit, each on its block and on no other name; those of large blocks first. Counts the others.
std::string names(const scene::Scene& scene, const View& view, std::size_t& left_out) {
  constexpr double letter = 6;  // pixels
  constexpr double row = 13;
  constexpr double beyond = 1.2;  // of the block's width and height
  const double per_pixel = (view.right - view.left) / frame_width;
  std::vector<std::pair<std::vector<scene::Point>, const scene::Block*>> seen;
  for (const scene::Block& block : scene.blocks) {
    auto pieces = in_view(block.vertices, view);
    if (!pieces.empty()) seen.emplace_back(std::move(pieces.front()), &block);
  }
  std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) {
    return geometry::signed_area(a.first) > geometry::signed_area(b.first);
  });
  std::string script;
  std::vector<Eigen::AlignedBox2d> taken;
  for (const auto& [outline, block] : seen) {
    const scene::Point middle = geometry::centroid(outline);
    const scene::Point half = per_pixel / 2 * scene::Point(letter * static_cast<double>(block->name.size()), row);
    const Eigen::AlignedBox2d box(middle - half, middle + half);
    const geometry::Bounds bounds = geometry::bounds_of(outline);
    const bool fits = (2 * half.array() <= beyond * (bounds.high - bounds.low).array()).all();
    if (!fits || std::any_of(taken.begin(), taken.end(), [&](const auto& other) { return other.intersects(box); })) {
      ++left_out;
      continue;
    }
    taken.push_back(box);
    script += fmt::format("set label {} at {},{} center front font ',8'\n", gnuplot_text(block->name), middle.x(),
                          middle.y());
  }
  return script;
}

/// Returns how many names of blocks in the picture it leaves out.
std::size_t draw(const scene::Scene& scene, const std::filesystem::path& out) {
  const View view = view_of_structure(scene);
  const double aspect = std::clamp((view.top - view.bottom) / (view.right - view.left), 0.2, 3.0);
  std::string script = fmt::format(
      "set title {}\nset size ratio -1\nunset key\n"
      "set tics out nomirror\nset xlabel 'x (m)'\nset ylabel 'elevation (m)'\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
      gnuplot_title(scene.title, picture_width), view.left, view.right, view.bottom, view.top);
  int number = 0;
  for (const scene::Block& block : scene.blocks)
    script += gnuplot_polygon(number, block.vertices, view, style_of(block));
  std::size_t left_out = 0;
  script += names(scene, view, left_out);
  picture::draw({{out, picture_width, 80 + frame_width * aspect, script + "plot NaN notitle\n"}});
  return left_out;
}

}  // namespace

void cut(const CutOptions& options) {
  results::require_writable_file("--out", options.out, {".png", ".svg"});
  const scene::ReadScene read = scene::read(options.scene, options.overrides);
  for (const auto& note : read.notes) fmt::print(stderr, "{}", results::for_stderr(note.text() + "\n"));
  const scene::Scene& scene = read.scene;
  const std::size_t left_out = draw(scene, options.out);
  std::vector<double> areas;
  for (const scene::Block& block : scene.blocks) areas.push_back(geometry::signed_area(block.vertices));
  const auto [smallest, largest] = std::minmax_element(areas.begin(), areas.end());
  const auto fixed = std::count_if(scene.blocks.begin(), scene.blocks.end(), [](const auto& b) { return b.fixed; });
  const auto touching = scene::touching_pairs(scene, scene::rounding_ratio * scene::structure_size_m(scene.blocks));
  fmt::print("{} ({} fixed) of {:.4g} to {:.4g} m2, {}; drawn in {}{}\n", results::counted(areas.size(), "block"),
             fixed, *smallest, *largest, results::counted(touching.size(), "joint"), options.out.string(),
             left_out == 0 ? "" : fmt::format("; {} without room left out", results::counted(left_out, "name")));
}

}  // namespace blockweir::picture
