// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/growing_cracks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solid/answers/answer_entries.hpp"
#include "solid/answers/safety_reserves.hpp"
#include "solid/capacity/static_strength.hpp"

namespace blockweir::solid {
namespace {

bool lets_in_water(const scene::JointLaw& law) {
  return law.uplift == scene::Uplift::cracked;
}

bool has_cracks(const scene::Scene& scene) {
  return lets_in_water(scene.default_joint) ||
         std::any_of(scene.joints.begin(), scene.joints.end(), [](const auto& j) { return lets_in_water(j.law); });
}

}  // namespace

void add_growing_cracks(const Situation& now, const process::FluidMaker& make_fluid, nlohmann::json& answer) {
  if (!now.water || answer.value("outcome", "") != "stands" || !has_cracks(now.scene)) return;
  std::string kept;
  if (answer.contains("water_factor")) {
    nlohmann::json& found = answer["water_factor"];
    found["keeps_cracks"] = true;
    if (found["factor"].is_number() && found["factor"] < scarce_water_factor) return;  // it has been warned of
    if (found["factor"].is_number()) kept = fmt::format(", for {:.5g} times", found["factor"].get<double>());
  }
  scene::Scene heavier = now.scene;
  heavier.water.density_kg_per_m3 *= scarce_water_factor;
  const auto still = attempt([&] {
    Situation then(heavier, make_fluid);
    return stands(then.scene, then.water_if_any(), then.level_m);
  });
  if (!still.value || *still.value) return;
  answer["warnings"].push_back(
      fmt::format("near its end: with {:.5g} times what the water presses it does not stand, as cracks grow and let in "
                  "more (uplift = \"cracked\"); limit analysis keeps them as they are{}; look at `level`",
                  scarce_water_factor, kept));
}

}  // namespace blockweir::solid
