// SPDX-License-Identifier: GPL-3.0-or-later
// The margin of a run by limit analysis: the factor on strength, and the surfaces on which its mechanism moves.
#include <fmt/format.h>

#include <cmath>

#include "bridge/process/answers.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/answers/crushed_corners.hpp"
#include "solid/answers/strain_that_lets_go.hpp"
#include "solid/capacity/situation.hpp"
#include "solid/limit/limit_strength.hpp"

namespace blockweir::process {
namespace {

using nlohmann::json;
using solid::limit::Bearing;
namespace limit = solid::limit;

/// Beyond it the programs take longer than a run's end may.
constexpr std::size_t most_faces = 300;

/// For a structure that overturns whatever its strength: the share of the reservoir's forces that it can just carry.
json add_reservoir_factor(solid::Situation& now, const limit::LimitAnalysis& structure, const limit::Wrenches& loads,
                          json answer) {
  if (!now.water) return answer;
  const limit::Wrenches full = statics::water_forces(now.scene, now.water->at(now.level_m));
  const limit::Wrenches reservoir =
      limit::combined(full, -1, statics::water_forces(now.scene, now.water->at(now.water->range().empty_m)));
  const limit::LargestFactor found = structure.largest_factor(limit::combined(loads, -1, reservoir), reservoir);
  if (found.bearing != Bearing::fails_at_a_factor) return answer;
  answer["reservoir_factor"] = found.factor;
  answer["mechanism"] = solid::mechanism_json(structure, found.mechanism);
  return answer;
}

json margin_of(solid::Situation& now, const limit::LimitAnalysis& structure, const limit::Wrenches& loads) {
  const limit::LimitStrength found = limit::limit_strength(structure, loads);
  json answer;
  if (found.bearing == Bearing::fails_at_a_factor) {
    answer = {
        {"factor", found.factor}, {"gap", found.gap}, {"mechanism", solid::mechanism_json(structure, found.mechanism)}};
  } else {
    const bool any = found.bearing == Bearing::bears_any;
    answer =
        add_reservoir_factor(now, structure, loads,
                             {{"factor", nullptr},
                              {"why_no_factor", any ? "no joint needs shear strength"
                                                    : "no shear strength of the joints would hold the structure"}});
    answer["holds_nothing"] = !any;
    if (!any && !answer.contains("mechanism")) answer["mechanism"] = solid::mechanism_json(structure, found.mechanism);
  }
  if (found.jams) solid::add_note(solid::jams_note, answer);
  solid::add_strength_with_crushed_corners(structure, loads, found, answer);
  return answer;
}

}  // namespace

json margin_answer(const scene::Scene& scene, const FluidMaker& make_fluid) {
  const limit::LimitAnalysis structure(scene);
  if (structure.faces().size() > most_faces) {
    return {
        {"factor", nullptr},
        {"level_m", nullptr},
        {"why_no_factor",
         fmt::format(
             "a run looks for it only up to {} faces between blocks, and here are {}; \"blockweir safety\" finds it, "
             "which may take long",
             most_faces, structure.faces().size())}};
  }
  solid::Situation now(scene, make_fluid);
  const limit::Wrenches stated = statics::stated_loads_of(scene, scene.analysis.duration_s);
  json answer = margin_of(now, structure, limit::combined(now.dead(), 1, stated));
  solid::add_what_limit_analysis_takes(structure, answer);
  answer["stands_by_any_forces"] = solid::stands_by_any_forces(structure);
  answer["level_m"] = std::isnan(now.level_m) ? json() : json(now.level_m);
  return answer;
}

}  // namespace blockweir::process
