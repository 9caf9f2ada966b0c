// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/cut.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/picture/draw.hpp"
#include "bridge/picture/gnuplot.hpp"
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

constexpr std::size_t most_names = 150;  // more would cover each other

std::string style_of(const scene::Block& block) {
  constexpr const char* colours[] = {"#c9c9c4", "#d9c8a9", "#b7c7b0", "#c6b7cc", "#b5c4d4", "#dcbdb2"};
  return fmt::format("fc rgb '{}' fillstyle solid border lc rgb '#303030' lw 1",
                     block.fixed ? "#8d7f6d" : colours[static_cast<std::size_t>(block.material) % std::size(colours)]);
}

void draw(const scene::Scene& scene, const std::filesystem::path& out) {
  const geometry::Bounds all = scene::bounds_of(scene);
  const scene::Point span = all.high - all.low;
  const scene::Point edge = scene::Point::Constant(0.03 * all.size());
  const View seen = view_of({all.low - edge, all.high + edge});
  const double aspect = std::clamp(span.y() / span.x(), 0.2, 3.0);
  std::string script = fmt::format(
      "set title {}\nset size ratio -1\nunset key\n"
      "set tics out nomirror\nset xlabel 'x (m)'\nset ylabel 'elevation (m)'\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
      gnuplot_title(scene.title, 1200), seen.left, seen.right, seen.bottom, seen.top);
  int number = 0;
  for (const scene::Block& block : scene.blocks) {
    script += gnuplot_polygon(number, block.vertices, seen, style_of(block));
    if (scene.blocks.size() > most_names) continue;
    const scene::Point middle = geometry::centroid(block.vertices);
    script +=
        fmt::format("set label {} at {},{} center front font ',8'\n", gnuplot_text(block.name), middle.x(), middle.y());
  }
  picture::draw({{out, 1200, 80 + 1120 * aspect, script + "plot NaN notitle\n"}});
}

}  // namespace

void cut(const CutOptions& options) {
  results::require_writable_file("--out", options.out, {".png", ".svg"});
  const scene::ReadScene read = scene::read(options.scene, options.overrides);
  for (const auto& note : read.notes) fmt::print(stderr, "{}", results::for_stderr(note.text() + "\n"));
  const scene::Scene& scene = read.scene;
  draw(scene, options.out);
  std::vector<double> areas;
  for (const scene::Block& block : scene.blocks) areas.push_back(geometry::signed_area(block.vertices));
  const auto [smallest, largest] = std::minmax_element(areas.begin(), areas.end());
  const auto fixed = std::count_if(scene.blocks.begin(), scene.blocks.end(), [](const auto& b) { return b.fixed; });
  const auto touching = scene::touching_pairs(scene, scene::rounding_ratio * scene::structure_size_m(scene.blocks));
  fmt::print("{} ({} fixed) of {:.4g} to {:.4g} m2, {}; drawn in {}\n", results::counted(areas.size(), "block"), fixed,
             *smallest, *largest, results::counted(touching.size(), "joint"), options.out.string());
}

}  // namespace blockweir::picture
