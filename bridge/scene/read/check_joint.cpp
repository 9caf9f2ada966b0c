// SPDX-License-Identifier: GPL-3.0-or-later
// Reports a named joint whose law has no effect: its blocks do not touch, do not move, or are bonded over more than
// their common length.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/read/check.hpp"
#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {
namespace {

/// Distance between two boxes, 0 where they meet.
double distance(const geometry::Bounds& a, const geometry::Bounds& b) {
  return (b.low - a.high).cwiseMax(a.low - b.high).cwiseMax(0).norm();
}

/// "foundation" touches "lower": what each of the two blocks does touch, the ones nearest to the other block first.
std::string touching_pairs(const Reading& reading, const std::array<int, 2>& between, double touching_m) {
  const auto& blocks = reading.scene.blocks;
  std::string text;
  for (const std::size_t side : {0U, 1U}) {
    const Block& block = blocks[at(between[side])];
    const geometry::Bounds own = geometry::bounds_of(block.vertices);
    const geometry::Bounds other = geometry::bounds_of(blocks[at(between[1 - side])].vertices);
    const Block* nearest = nullptr;
    double least = 0;
    for (const Block& candidate : blocks) {
      if (&candidate == &block || candidate.vertices.empty()) continue;
      if (distance(geometry::bounds_of(candidate.vertices), own) > touching_m) continue;
      if (trace_joint(block, candidate, touching_m).pieces.empty()) continue;
      const double away = distance(geometry::bounds_of(candidate.vertices), other);
      if (nearest != nullptr && away >= least) continue;
      nearest = &candidate;
      least = away;
    }
    if (nearest == nullptr) continue;
    text += fmt::format("{}\"{}\" touches \"{}\"", text.empty() ? "" : ", ", block.name, nearest->name);
  }
  return text.empty() ? "move them together, or leave the joint out" : text;
}

/// Least distance of two outlines [m].
double distance_between(const std::vector<Point>& a, const std::vector<Point>& b) {
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const std::vector<Point>& points, const std::vector<Point>& outline) {
    for (const Point& p : points) {
      for (std::size_t i = 0; i < outline.size(); ++i) {
        least = std::min(least, geometry::distance_to_segment(p, outline[i], outline[(i + 1) % outline.size()]));
      }
    }
  };
  look(a, b);
  look(b, a);
  return least;
}

}  // namespace

void check_joint(TableReader& table, Reading& reading, const Joint& joint, double touching_m) {
  const Block* a = reading.sound_block(joint.between[0]);
  const Block* b = reading.sound_block(joint.between[1]);
  if (a == nullptr || b == nullptr || a == b || reading.problems.full()) return;
  if (a->fixed && b->fixed) {
    return reading.problems.error(
        table.place("between"),
        fmt::format("{} has no effect: \"{}\" and \"{}\" are both fixed", table.name(), a->name, b->name),
        "a block that can move on one side", "leave the joint out, or free one of the blocks");
  }
  const JointTrace trace = trace_joint(*a, *b, touching_m);
  const JointLaw& law = joint.law;
  if (trace.pieces.empty() && overlap(*a, *b)) return;  // an error of its own: check_overlaps()
  if (trace.pieces.empty()) {
    const bool asks = law.uplift != Uplift::none || law.cohesion_pa > 0 || law.tension_strength_pa > 0;
    const std::string found = fmt::format("blocks \"{}\" and \"{}\" of {} do not touch ({:.3g} m apart)", a->name,
                                          b->name, table.name(), distance_between(a->vertices, b->vertices));
    const std::string nearest = touching_pairs(reading, joint.between, touching_m);
    if (asks) {
      return reading.problems.error(table.place("between"), found + ": its bond or uplift acts nowhere",
                                    "two blocks that touch along a line", nearest);
    }
    return reading.problems.warning(table.place("between"), found + ": its law acts once they meet",
                                    "two blocks that touch along a line, unless one is to fall onto the other",
                                    nearest);
  }
  if (table.has("bonded_length_m") && law.bonded_length_m > trace.length_m + touching_m) {
    reading.problems.error(table.place("bonded_length_m"),
                           fmt::format("bonded_length_m {} in {} is longer than the joint, {:.6g} m",
                                       *law.bonded_length_m, table.name(), trace.length_m),
                           "a length up to the joint's",
                           "shorten it, or leave it out: all of the joint is then bonded");
  }
}

}  // namespace blockweir::scene
