// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/safety_reserves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/statics/loads.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/limit/determinacy.hpp"
#include "solid/watch/edge_tension.hpp"

namespace blockweir::solid {

using limit::Bearing;

namespace {

/// The same with the cohesion of the part that is not cracked.
scene::Scene with_cracked_joints(scene::Scene scene, const std::vector<CrackedJoint>& cracked) {
  for (const CrackedJoint& c : cracked) {
    auto joint = std::find_if(scene.joints.begin(), scene.joints.end(), [&](const scene::Joint& j) {
      return std::pair<int, int>(std::minmax(j.between[0], j.between[1])) == c.blocks;
    });
    if (joint == scene.joints.end()) {
      joint = scene.joints.insert(joint, {c.name, {c.blocks.first, c.blocks.second}, scene.default_joint});
    }
    joint->law.cohesion_pa *= 1 - c.cracked;
  }
  return scene;
}

bool slip_destroys(const scene::JointLaw& law) {
  return law.cohesion_pa > 0 && !law.keeps_cohesion;
}

/// What stays once all such bonds are lost.
scene::Scene without_bonds(scene::Scene scene) {
  const auto lose = [](scene::JointLaw& law) {
    if (!slip_destroys(law)) return;
    law.cohesion_pa = law.tension_strength_pa = 0;
    law.friction_angle_deg = law.residual_friction_angle_deg;
  };
  lose(scene.default_joint);
  for (scene::Joint& joint : scene.joints) lose(joint.law);
  return scene;
}

}  // namespace

void add_water_factor(const limit::LimitAnalysis& structure, Situation& now, const limit::Wrenches& stated,
                      const limit::LimitStrength& strength, nlohmann::json& answer) {
  if (!now.water) return;
  const limit::Wrenches dry = limit::combined(statics::weights_of(now.scene), 1, stated);
  const auto found = attempt(
      [&] { return structure.largest_factor(dry, statics::water_forces(now.scene, now.water->at(now.level_m))); });
  if (!found.value || found.value->bearing == Bearing::bears_any) return;
  if (found.value->bearing == Bearing::bears_none) {
    answer["water_factor"] = {{"factor", nullptr}};  // what acts beside the water is too much already
    return;
  }
  const double factor = found.value->factor;
  answer["water_factor"] = {{"factor", factor}, {"gap", found.value->gap}};
  constexpr double scarce = 1.1;
  const bool strong = strength.bearing == Bearing::bears_any ||
                      (strength.bearing == Bearing::fails_at_a_factor && strength.factor > scarce);
  const bool fails = answer.value("outcome", "") == "fails";  // no more is to be said of how near its end is
  if (fails || factor < 1 || factor >= scarce) return;
  answer["warnings"].push_back(
      fmt::format("near its end: {:.5g} times what the water presses, its uplift included, brings it down, by limit "
                  "analysis; {}look at the resultants and at `level`",
                  factor, strong ? "a factor on strength does not see how near a structure is to turning over: " : ""));
}

void add_stretch_of_anchors(Situation& now, const StaticStrength& found, nlohmann::json& answer) {
  if (now.scene.bolts.empty() || found.bearing == Bearing::bears_none) return;
  constexpr double share = 0.1;
  constexpr double seen = 1e-2;
  scene::Scene stiff = now.scene;
  stiff.analysis.failure_displacement_m *= share;
  const double guess = found.bearing == Bearing::fails_at_a_factor ? found.factor : 1;
  const auto other = attempt([&] { return static_strength(stiff, now.water_if_any(), now.level_m, guess); });
  if (!other.value || other.value->bearing != Bearing::fails_at_a_factor) return;
  const double factor = other.value->factor;
  if (found.bearing == Bearing::fails_at_a_factor && factor > found.factor * (1 - seen)) return;
  answer["with_less_stretch"] = {{"factor", factor}, {"failure_displacement_m", stiff.analysis.failure_displacement_m}};
  answer["warnings"].push_back(
      fmt::format("the blocks' factor counts on anchors that stretch while blocks move, by up to "
                  "failure_displacement_m = {:.3g} m; if they may move by {:.3g} m only it is {:.5g}: state as "
                  "failure_displacement_m what the structure may move",
                  now.scene.analysis.failure_displacement_m, stiff.analysis.failure_displacement_m, factor));
}

void add_rigid_blocks(const limit::LimitAnalysis& structure, Situation& now, const StaticStrength& found,
                      std::optional<double> jumps_below, nlohmann::json& answer) {
  constexpr double share = 0.95;  // friction that is not determined jumps by less from one analysis to the next
  if (structure.is_exact() || !strains(now.scene) || found.bearing == Bearing::bears_none) return;
  const scene::Scene rigid = with_rigid_blocks(now.scene);
  const double weaker = share * (found.bearing == Bearing::fails_at_a_factor ? found.factor : 1);
  const auto without = attempt([&] {
    if (stands(with_reduced_strength(rigid, weaker), now.water_if_any(), now.level_m)) return StaticStrength{};
    return static_strength(rigid, now.water_if_any(), now.level_m, weaker, jumps_below);
  });
  if (!without.value || without.value->bearing != Bearing::fails_at_a_factor) return;
  const double factor = without.value->factor;
  const std::string text = fmt::format(
      "the same blocks without strain have a factor of {:.4g}: what holds them beyond is how strain presses them "
      "against each other, by Poisson's ratio for one, which equilibrium does not ask for; the lower counts",
      factor);
  answer["with_rigid_blocks"] = {{"factor", factor}, {"text", text}};
  answer["warnings"].push_back(text);
}

void add_brittle_bonds(const limit::LimitAnalysis& structure, Situation& now, const StaticStrength& found,
                       const limit::Wrenches& loads, nlohmann::json& answer) {
  constexpr double share = 0.95;
  if (found.bearing != Bearing::fails_at_a_factor) return;
  const auto weak = [](const limit::Face& face) { return face.length_m() > 0 && slip_destroys(*face.law); };
  if (!limit::share_a_loop(now.scene, structure.faces(), weak)) return;
  const auto without =
      attempt([&] { return limit::limit_strength(limit::LimitAnalysis(without_bonds(now.scene)), loads); });
  if (!without.value || without.value->bearing == Bearing::bears_any) return;
  const double factor = without.value->bearing == Bearing::bears_none ? 0 : without.value->factor;
  if (factor > share * found.factor) return;
  const std::string text = fmt::format(
      "bonds of joints break one after the other, and equilibrium does not say which is the first: the blocks' "
      "factor of {:.4g} may change by much where the scene changes by little; without bonds it is {:.4g}, by limit "
      "analysis. `keeps_cohesion = true` states bonds that slip does not destroy",
      found.factor, factor);
  answer["without_bonds"] = {{"factor", factor}, {"text", text}};
  answer["warnings"].push_back(text);
}

void add_cracked_joints(const Solid& blocks, Situation& now, nlohmann::json& answer) {
  EdgeTension edge;
  edge.look(blocks, std::numeric_limits<double>::quiet_NaN(), now.level_m);
  if (const std::string warning = edge.warning(); !warning.empty()) answer["warnings"].push_back(warning);
  const std::vector<CrackedJoint> cracked = EdgeTension::cracked_joints(blocks);
  if (cracked.empty()) return;
  const scene::Scene weaker = with_cracked_joints(now.scene, cracked);
  const auto found = attempt([&] {
    const limit::Wrenches stated = statics::stated_loads_of(weaker, weaker.analysis.duration_s);
    return limit::limit_strength(limit::LimitAnalysis(weaker), limit::combined(now.dead(), 1, stated));
  });
  if (!found.value || found.value->bearing == Bearing::bears_any) return;
  const double factor = found.value->bearing == Bearing::bears_none ? 0 : found.value->factor;
  const auto most = std::max_element(cracked.begin(), cracked.end(),
                                     [](const auto& a, const auto& b) { return a.cracked < b.cracked; });
  answer["with_cracked_joint"] = {
      {"factor", factor},
      {"text", fmt::format("with cohesion on what is not in tension alone it is {:.5g}, by limit analysis; most is in "
                           "tension of joint \"{}\", {:.3g} % of it",
                           factor, most->name, 100 * most->cracked)}};
}

}  // namespace blockweir::solid
