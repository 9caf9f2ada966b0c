// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/uplift_in_tension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bridge/scene/cracks.hpp"

namespace blockweir::solid {
namespace {

using scene::Crack;
using scene::Uplift;

/// Blocks have strained a little where the row was made.
bool is_of(const JointRow& row, const Crack& crack) {
  constexpr double strained = 1e-2;
  const double off_m = strained * row.length_m;
  return std::abs(crack.length_m - row.length_m) < off_m && (crack.end() - row.downstream_end_m).norm() < off_m;
}

/// How such a law treats a crack; nullptr for those that follow it, or have the full pressure anyway.
const char* makes_of_a_crack(Uplift law) {
  switch (law) {
    case Uplift::drained:
    case Uplift::triangular:
      return "takes it to be closed";
    case Uplift::flow:
      return "lets water through it as if its faces touched";
    case Uplift::none:
      return "keeps water out of it";
    case Uplift::heads:
      return "keeps its heads where the crack has run past them";
    default:
      return nullptr;
  }
}

/// The law of a row's water, where all of the row or the joint at its upstream end has one of those above.
std::optional<Uplift> law_of(const scene::Scene& scene, const std::vector<Crack>& cracks, const JointRow& row) {
  const auto crack = std::find_if(cracks.begin(), cracks.end(), [&](const Crack& c) { return is_of(row, c); });
  if (crack != cracks.end()) return crack->law;
  constexpr double strained = 1e-2;
  for (const Uplift law : {Uplift::flow, Uplift::none}) {
    for (const Crack& joint : scene::find_joints(scene, law)) {
      for (const Point& end : {joint.mouth(), joint.end()}) {
        if ((end - row.upstream_end_m).norm() < strained * row.length_m) return law;
      }
    }
  }
  return std::nullopt;
}

/// Whether water stands at the end that opens, the one farther from the resultant: else there is air in the crack.
bool reaches_the_mouth(const wire::Load& water, const JointRow& row) {
  const bool at_heel = row.resultant_from_downstream < 0.5;
  return at_heel ? row.upstream_end_m.y() < water.upstream_level_m
                 : row.downstream_end_m.y() < water.downstream_level_m;
}

}  // namespace

std::vector<std::string> uplift_warnings(const scene::Scene& scene, const wire::Load& water,
                                         const std::vector<JointRow>& rows) {
  constexpr double seen = 1e-2;
  std::vector<std::string> warnings;
  const std::vector<Crack> cracks = scene::find_cracks(scene);
  for (const JointRow& row : rows) {
    if (row.cracked_length_m <= seen * row.faces_length_m) continue;
    const auto law = law_of(scene, cracks, row);
    const char* makes = law ? makes_of_a_crack(*law) : nullptr;
    if (makes == nullptr || !reaches_the_mouth(water, row)) continue;
    warnings.push_back(
        fmt::format("joint \"{}\" is in tension over {:.3g} % of its length, by the gravity method, and uplift = "
                    "\"{}\" {}; water in a crack has the full pressure of its mouth: state uplift = \"cracked\"",
                    row.name, 100 * row.cracked_length_m / row.faces_length_m, scene::named(*law).name, makes));
  }
  return warnings;
}

}  // namespace blockweir::solid
