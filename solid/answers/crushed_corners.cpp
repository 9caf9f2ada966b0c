// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/crushed_corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/geometry/place_text.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::solid {
namespace {

using limit::Bearing;
using limit::Face;
using limit::Filled;
using limit::Kinks;
using limit::LimitAnalysis;
using nlohmann::json;

constexpr double lower = 1e-3;  ///< smaller differences are not reported

bool has_kinks(const LimitAnalysis& structure) {
  return std::any_of(structure.faces().begin(), structure.faces().end(), [](const Face& f) { return f.in_kink; });
}

/// The first corner that would hold against the mechanism of the structure without them: by associated flow it would
/// have to open by its friction times its slip.
std::string crushed_in(const LimitAnalysis& structure, const limit::Twists& mechanism, double reduction = 1) {
  constexpr double least = 1e-6;  // of the fastest vertex
  const auto& blocks = structure.scene().blocks;
  for (const Face& face : structure.faces()) {
    if (!face.in_kink) continue;
    const limit::Point jump = structure.jump(face, mechanism, face.from_m);
    const double opens = jump.dot(face.normal) - face.friction / reduction * std::abs(jump.dot(face.along()));
    if (opens > -least) continue;
    return fmt::format("the corner between blocks \"{}\" and \"{}\" at {} m", blocks[at(face.a)].name,
                       blocks[at(face.b)].name, geometry::place_text(face.from_m, scene::structure_size_m(blocks)));
  }
  return "a corner in a kink";
}

void add(json& answer, const char* key, double value, const std::string& text) {
  answer["with_crushed_corners"] = {{key, value}, {"text", text}};
  answer["warnings"].push_back(text);
}

}  // namespace

void add_strength_with_crushed_corners(const LimitAnalysis& structure, const limit::Wrenches& loads,
                                       const limit::LimitStrength& found, json& answer) {
  if (!has_kinks(structure) || found.bearing == Bearing::bears_none) return;
  const LimitAnalysis crushed(structure.scene(), Kinks::give_way);
  const limit::LimitStrength without = limit::limit_strength(crushed, loads);
  if (without.bearing != Bearing::fails_at_a_factor) return;
  if (found.bearing == Bearing::fails_at_a_factor && without.factor > found.factor * (1 - lower)) return;
  add(answer, "factor", without.factor,
      fmt::format("{} bears its force on no length: where it is crushed, the factor is {:.5g} by limit analysis",
                  crushed_in(structure, without.mechanism, without.factor), without.factor));
}

void add_level_with_crushed_corners(const LimitAnalysis& structure, const limit::Wrenches& dead,
                                    const limit::WaterAtLevel& water, const limit::LevelRange& range,
                                    const limit::LimitLevel& found, json& answer) {
  if (!has_kinks(structure) || found.outcome == Filled::does_not_stand_empty) return;
  const LimitAnalysis crushed(structure.scene(), Kinks::give_way);
  const limit::LimitLevel without = limit::limit_level(crushed, dead, water, range);
  if (without.outcome == Filled::stands_full) return;
  if (without.outcome == Filled::does_not_stand_empty) {
    add(answer, "level_m", range.empty_m,
        "a corner in a kink bears its force on no length: where it is crushed, limit analysis finds that the structure "
        "does not stand with an empty reservoir");
    return;
  }
  if (found.outcome == Filled::fails && found.level_m - without.level_m < lower * (found.level_m - range.empty_m))
    return;
  add(answer, "level_m", without.level_m,
      fmt::format("{} bears its force on no length: where it is crushed, it fails at {:.6g} m by limit analysis",
                  crushed_in(structure, without.at_it.mechanism), without.level_m));
}

}  // namespace blockweir::solid
