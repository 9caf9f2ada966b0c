// SPDX-License-Identifier: GPL-3.0-or-later
// The failure level of one sample of many: as in level_answer(), but by one method only and without texts for
// readers.
#include "bridge/process/answers.hpp"
#include "bridge/statics/loads.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/capacity/static_level.hpp"
#include "solid/limit/limit_level.hpp"

namespace blockweir::process {
namespace {

using nlohmann::json;
using solid::StillWater;
using solid::limit::Filled;
namespace limit = solid::limit;

/// `empty_m`, `full_m`: between which levels it was looked for.
json capacity_json(Filled outcome, double level_m, const limit::LevelRange& range) {
  const bool fails = outcome == Filled::fails;
  const char* word = fails ? "fails" : outcome == Filled::stands_full ? "stands" : "does not stand empty";
  return {{"outcome", word},
          {"level_m", fails ? json(level_m) : json()},
          {"empty_m", range.empty_m},
          {"full_m", range.full_m}};
}

/// Forces of weight and loads.
limit::Wrenches dead_of(const scene::Scene& scene) {
  return limit::combined(statics::weights_of(scene), 1, statics::stated_loads_of(scene, scene.analysis.duration_s));
}

json by_limit_analysis(const scene::Scene& scene, StillWater& water) {
  const limit::LimitAnalysis structure(scene);
  const limit::Wrenches dead = dead_of(scene);
  const auto water_at = [&](double level_m) { return statics::water_forces(scene, water.at(level_m)); };
  const limit::LimitLevel found = limit_level(structure, dead, water_at, water.range());
  json answer = capacity_json(found.outcome, found.level_m, water.range());
  solid::add_what_limit_analysis_takes(structure, answer);
  if (found.outcome != Filled::fails) return answer;
  const limit::MechanismDescription words = limit::words_of(structure, found.at_it.mechanism);
  answer["mode"] = words.mode;
  if (!words.joints.empty()) answer["joint"] = words.joints.front();
  if (words.mouth_m) answer["head_m"] = found.level_m - words.mouth_m->y();
  return answer;
}

json by_the_blocks(const scene::Scene& scene, StillWater& water) {
  constexpr double exact = 1e-10;
  const auto bears_empty = solid::attempt([&] {
    const limit::Wrenches tailwater = statics::water_forces(scene, water.at(water.range().empty_m));
    return limit::LimitAnalysis(scene).bears(limit::combined(dead_of(scene), 1, tailwater));
  });
  const bool falls = bears_empty.value && !*bears_empty.value;
  const solid::StaticLevel found = solid::static_level(scene, water, exact, {.falls_as_drawn = falls});
  json answer = capacity_json(found.outcome, found.level_m, water.range());
  if (found.outcome != Filled::fails || !found.failure) return answer;
  answer["mode"] = found.failure->mode;
  answer["joint"] = found.failure->joint;
  answer["head_m"] = found.failure->head_m + (found.level_m - found.failure->level_m);
  return answer;
}

}  // namespace

json capacity_answer(const scene::Scene& scene, const FluidMaker& make_fluid, Capacity by) {
  StillWater water(scene, make_fluid);
  return by == Capacity::limit ? by_limit_analysis(scene, water) : by_the_blocks(scene, water);
}

}  // namespace blockweir::process
