// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts and sets of joints that leave nothing in the section that they cut.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/joint_trace.hpp"
#include "bridge/scene/read/cuts.hpp"

namespace blockweir::scene {
namespace {

/// A part of a boundary along a line whose law it does not have.
struct Unheeded {
  std::array<int, 2> blocks{};
  double length_m = 0;
  int id = 0;  ///< of the line whose law it has
};

/// What all lines of a name have done: a drawing has many of one name.
struct Effect {
  std::size_t lines = 0;
  std::size_t parting = 0;     ///< of them, those along which blocks touch
  bool law = false;            ///< some joint has it
  double longest_joint_m = 0;  ///< of those
  bool beside_region = false;  ///< along some boundary with the law of a region's outline
  std::vector<Unheeded> unheeded{};
  const Cuts::Source* first_idle = nullptr;
  const Cuts::Source* source = nullptr;
  double bonded_length_m = 0;
};

/// Between two blocks.
struct Boundary {
  std::array<int, 2> blocks{};
  std::vector<TracePiece> pieces{};  ///< its straight parts
  double length_m = 0;
  int id = 0;  ///< of the line whose law it has
};

Point middle(const TracePiece& piece) {
  return (piece.from_m + piece.to_m) / 2;
}

std::vector<Boundary> boundaries_of(const Reading& reading, const geometry::Cut& cut, std::size_t first,
                                    double tolerance_m) {
  std::vector<Boundary> all;
  const auto& blocks = reading.scene.blocks;
  for (const geometry::Neighbours& pair : cut.neighbours) {
    JointTrace trace = trace_joint(blocks[first + at(pair.a)], blocks[first + at(pair.b)], tolerance_m);
    all.push_back({.blocks = {static_cast<int>(first) + pair.a, static_cast<int>(first) + pair.b},
                   .pieces = std::move(trace.pieces),
                   .length_m = trace.length_m,
                   .id = pair.id});
  }
  return all;
}

bool holds(const geometry::Line& line, const Point& p, double tolerance_m) {
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    if (geometry::distance_to_segment(p, line.points[i], line.points[i + 1]) <= tolerance_m) return true;
  }
  return false;
}

/// Does the line run along some straight part of the boundary?
bool runs_along(const geometry::Line& line, const Boundary& boundary, double tolerance_m) {
  return std::any_of(boundary.pieces.begin(), boundary.pieces.end(),
                     [&](const TracePiece& piece) { return holds(line, middle(piece), tolerance_m); });
}

/// Of the line that a piece lies on, the smallest where lines coincide; -1: on none.
int line_of(const TracePiece& piece, const Cuts& cuts, double tolerance_m) {
  int id = -1;
  for (const geometry::Line& line : cuts.lines) {
    if ((id < 0 || line.id < id) && holds(line, middle(piece), tolerance_m)) id = line.id;
  }
  return id;
}

/// Parts of bent boundaries along lines of another law than theirs.
void find_unheeded(const Cuts& cuts, const std::vector<Boundary>& boundaries, double tolerance_m,
                   std::map<std::string, Effect>& effects) {
  for (const Boundary& boundary : boundaries) {
    if (boundary.pieces.size() < 2) continue;
    for (const TracePiece& piece : boundary.pieces) {
      const int id = line_of(piece, cuts, tolerance_m);
      if (id < 0 || cuts.joints[at(id)].law == cuts.joints[at(boundary.id)].law) continue;
      const Cuts::Source& source = cuts.sources[at(id)];
      if (source.name.empty() || source.by_chance) continue;
      effects[source.name].unheeded.push_back({boundary.blocks, (piece.to_m - piece.from_m).norm(), boundary.id});
    }
  }
}

/// Where a region's outline has the law of [joint] instead, that is seldom meant: what is weak would hold.
void report_unheeded(Reading& reading, const Cuts& cuts, const Effect& effect) {
  const Unheeded& first = effect.unheeded.front();
  const auto& blocks = reading.scene.blocks;
  const std::string& law = cuts.sources[at(first.id)].name;
  const std::size_t more = effect.unheeded.size() - 1;
  const std::string found = fmt::format(
      R"({} has no effect along {:.4g} m between blocks "{}" and "{}": a longer part of their boundary {}{})",
      effect.source->name, first.length_m, blocks[at(first.blocks[0])].name, blocks[at(first.blocks[1])].name,
      law.empty() ? "is a [[region]]'s outline, which has the law of [joint]" : "has the law of " + law,
      more > 0 ? fmt::format("; nor along {} other part{} of boundaries", more, more == 1 ? "" : "s") : "");
  const char* expected = "one law for each boundary of two blocks";
  const char* remedy = "lead the cut along all of that boundary, or part one of the blocks where the cut ends";
  const bool of_region = std::any_of(effect.unheeded.begin(), effect.unheeded.end(),
                                     [&](const Unheeded& u) { return cuts.sources[at(u.id)].name.empty(); });
  of_region ? reading.problems.error(effect.source->place, found, expected, remedy)
            : reading.problems.warning(effect.source->place, found, expected, remedy);
}

void report(Reading& reading, const Cuts& cuts, const Effect& effect) {
  Problems& problems = reading.problems;
  const Cuts::Source& source = *effect.source;
  const char* remedy = "lead it from side to side, or to other cuts, or leave it out";
  if (effect.parting == 0) {
    const std::string found = source.name + " has no effect: it parts no block of the section";
    if (source.by_chance) return problems.warning(source.place, found, "joints that part blocks", remedy);
    return problems.error(source.place, found, "lines that part blocks", remedy);
  }
  if (effect.parting < effect.lines && !source.by_chance) {
    problems.warning(effect.first_idle->place,
                     fmt::format("{} of {} lines of {} {} no block of the section, which has no effect",
                                 effect.lines - effect.parting, effect.lines, source.name,
                                 effect.lines - effect.parting == 1 ? "parts" : "part"),
                     "lines that part blocks", remedy);
  }
  if (!effect.law && effect.beside_region && !source.by_chance) {
    return problems.error(source.place,
                          fmt::format("the law of {} has no effect: its two blocks meet along a longer part of a "
                                      "[[region]]'s outline, which has the law of [joint]",
                                      source.name),
                          "one law for each boundary of two blocks",
                          "lead the cut along all of that boundary, or part one of the blocks where the cut ends");
  }
  if (!effect.law) {
    return problems.warning(source.place,
                            fmt::format("the law of {} has no effect: other cuts lie on it, or make up more of the "
                                        "same boundaries",
                                        source.name),
                            "one law for each boundary of two blocks", "leave it out, or draw both as one cut");
  }
  if (!effect.unheeded.empty()) report_unheeded(reading, cuts, effect);
  if (!source.states_bond_length || effect.bonded_length_m <= effect.longest_joint_m * (1 + 1e-6)) return;
  problems.error(source.bonded_length,
                 fmt::format("bonded_length_m {} in {} is longer than its joints, {:.6g} m at most",
                             effect.bonded_length_m, source.name, effect.longest_joint_m),
                 "a length up to the joint's", "shorten it, or leave it out: all of the joint is then bonded");
}

}  // namespace

void check_cuts(Reading& reading, const Cuts& cuts, const geometry::Cut& cut, std::size_t first_block) {
  const bool any = std::any_of(cuts.sources.begin(), cuts.sources.end(), [](const auto& s) { return !s.name.empty(); });
  if (!any || cut.pieces.empty() || !cut.enclosed.empty()) return;  // what encloses has been reported
  double size_m = 0;
  for (const geometry::Piece& piece : cut.pieces) size_m = std::max(size_m, geometry::bounds_of(piece.vertices).size());
  const double tolerance_m = 1e-6 * size_m;
  const std::vector<Boundary> boundaries = boundaries_of(reading, cut, first_block, tolerance_m);
  std::vector<bool> has_law(cuts.joints.size(), false);
  for (const Boundary& boundary : boundaries) has_law[at(boundary.id)] = true;
  std::vector<bool> parts = has_law;
  std::vector<bool> beside_region(cuts.joints.size(), false);
  for (const geometry::Line& line : cuts.lines) {
    if (has_law[at(line.id)]) continue;
    for (const Boundary& boundary : boundaries) {
      if (!runs_along(line, boundary, tolerance_m)) continue;
      parts[at(line.id)] = true;
      if (cuts.sources[at(boundary.id)].name.empty()) beside_region[at(line.id)] = true;
    }
  }
  std::map<std::string, Effect> effects;
  for (std::size_t id = 0; id < cuts.sources.size(); ++id) {
    const Cuts::Source& source = cuts.sources[id];
    if (source.name.empty()) continue;
    Effect& effect = effects[source.name];
    if (effect.source == nullptr) effect.source = &source;
    ++effect.lines;
    if (parts[id]) ++effect.parting;
    if (beside_region[id]) effect.beside_region = true;
    if (!parts[id] && effect.first_idle == nullptr) effect.first_idle = &source;
    effect.bonded_length_m = cuts.joints[id].law.bonded_length_m.value_or(0);
  }
  for (const Boundary& boundary : boundaries) {
    const Cuts::Source& source = cuts.sources[at(boundary.id)];
    if (source.name.empty()) continue;
    Effect& effect = effects[source.name];
    effect.law = true;
    effect.longest_joint_m = std::max(effect.longest_joint_m, boundary.length_m);
  }
  find_unheeded(cuts, boundaries, tolerance_m, effects);
  for (const auto& [name, effect] : effects) report(reading, cuts, effect);
}

}  // namespace blockweir::scene
