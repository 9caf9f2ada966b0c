// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that lie side by side with a narrow gap between: blocks that seem meant to touch.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "bridge/scene/block_index.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/read/magnitudes.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::scene {
namespace {

constexpr double narrow_ratio = 0.02;    // of the smaller block: wider ones are seen in a drawing
constexpr double closed_ratio = 0.5e-6;  // of the structure, as the solid has it
constexpr double beside_ratio = 0.5;     // of the smaller block: so long are faces that seem meant to touch

/// Least distance of the faces of a trace, whose pieces lie along block a, from those of block b.
double narrowest(const JointTrace& beside, const Block& b) {
  double gap_m = std::numeric_limits<double>::infinity();
  for (const TracePiece& piece : beside.pieces) {
    const auto e = static_cast<std::size_t>(piece.edge_b);
    const Point& from = b.vertices[e];
    const Point& to = b.vertices[(e + 1) % b.vertices.size()];
    for (const Point& p : {piece.from_m, piece.to_m})
      gap_m = std::min(gap_m, geometry::distance_to_segment(p, from, to));
  }
  return gap_m;
}

/// Length of a trace between whose faces no other block lies, such as a layer of mortar.
double open_length_m(const Scene& scene, const BlockIndex& index, const JointTrace& beside, std::size_t a,
                     std::size_t b) {
  constexpr int samples = 16;
  const auto& outline = scene.blocks[b].vertices;
  double open_m = 0;
  for (const TracePiece& piece : beside.pieces) {
    const auto e = static_cast<std::size_t>(piece.edge_b);
    for (int k = 0; k < samples; ++k) {
      const Point on_a = piece.from_m + (k + 0.5) / samples * (piece.to_m - piece.from_m);
      const Point on_b = geometry::nearest_on_segment(on_a, outline[e], outline[(e + 1) % outline.size()]);
      const Point between = (on_a + on_b) / 2;
      const std::vector<std::size_t> near = index.meeting({between, between});
      const bool filled = std::any_of(near.begin(), near.end(), [&](std::size_t c) {
        return c != a && c != b && geometry::holds_point(scene.blocks[c].vertices, between, 0);
      });
      if (!filled) open_m += (piece.to_m - piece.from_m).norm() / samples;
    }
  }
  return open_m;
}

/// Water between the two blocks that the scene states and the gap removes; empty if it states none.
std::string lost_uplift(const Scene& scene, int a, int b) {
  if (scene.fluid == FluidModel::none) return {};
  const auto joint = std::find_if(scene.joints.begin(), scene.joints.end(), [&](const Joint& j) {
    return j.between == std::array{a, b} || j.between == std::array{b, a};
  });
  const Uplift law = (joint == scene.joints.end() ? scene.default_joint : joint->law).uplift;
  if (law == Uplift::none) return {};
  return fmt::format("; the uplift \"{}\" acts only in a joint whose faces touch: none acts here, which is unsafe",
                     named(law).name);
}

}  // namespace

void check_gaps(const Scene& scene, Problems& problems) {
  // Without gravity no gap closes; blocks that start without stress are probably thrown or dropped.
  if (scene.analysis.gravity_m_per_s2 == 0 || scene.analysis.start == Start::unstressed) return;
  const double touching_m = closed_ratio * structure_size_m(scene.blocks);
  const BlockIndex index(scene.blocks);
  for (std::size_t i = 0; i < scene.blocks.size(); ++i) {
    const Block& a = scene.blocks[i];
    const geometry::Bounds box = geometry::bounds_of(a.vertices);
    const Point margin = Point::Constant(narrow_ratio * box.size());
    for (const std::size_t j : index.meeting({box.low - margin, box.high + margin})) {
      const Block& b = scene.blocks[j];
      if (j == i || (a.fixed && b.fixed)) continue;
      const double size = geometry::bounds_of(b.vertices).size();
      if (size < box.size() || (size == box.size() && j < i)) continue;  // the smaller of two looks for the other
      const JointTrace beside = trace_joint(a, b, margin.x());
      if (beside.length_m < beside_ratio * box.size()) continue;
      const double gap_m = narrowest(beside, b);
      if (gap_m <= touching_m || open_length_m(scene, index, beside, i, j) < beside_ratio * box.size()) continue;
      problems.warning(
          problems.at(std::max(a.line, b.line)),
          fmt::format("blocks \"{}\" and \"{}\" have a gap of {:.3g} m between them near ({:.4g}, {:.4g}), "
                      "which is unusual for a structure that begins at rest{}",
                      a.name, b.name, gap_m, beside.mouth().x(), beside.mouth().y(),
                      lost_uplift(scene, static_cast<int>(i), static_cast<int>(j))),
          "blocks that touch, or are farther apart", "move the vertices of one of them to the common boundary");
    }
  }
}

}  // namespace blockweir::scene
