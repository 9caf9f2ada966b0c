// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/safety_reserves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bridge/statics/loads.hpp"
#include "solid/answers/answer_entries.hpp"
#include "solid/answers/other_orders.hpp"
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

/// What anchors bear before blocks move.
scene::Scene with_anchors_at_prestress(scene::Scene scene) {
  for (scene::Bolt& bolt : scene.bolts) bolt.yield_n_per_m = bolt.prestress_n_per_m;
  return scene;
}

/// A factor on the water, or null where nothing of it is borne; none where any of it is.
using WaterFactor = std::optional<nlohmann::json>;

WaterFactor water_factor(const Attempt<limit::LargestFactor>& found) {
  if (!found.value || found.value->bearing == Bearing::bears_any) return std::nullopt;
  return found.value->bearing == Bearing::bears_none ? nlohmann::json() : nlohmann::json(found.value->factor);
}

double or_zero(const nlohmann::json& factor) {
  return factor.is_number() ? factor.get<double>() : 0;
}

std::string near_its_end(double factor, const char* with, const limit::LimitStrength& strength) {
  const bool strong = strength.bearing == Bearing::bears_any ||
                      (strength.bearing == Bearing::fails_at_a_factor && strength.factor > scarce_water_factor);
  return fmt::format(
      "near its end: {:.5g} times what the water presses, its uplift included, brings it down{}, by limit analysis; "
      "{}look at the resultants and at `level`",
      factor, with, strong ? "a factor on strength does not see how near a structure is to turning over: " : "");
}

std::string stands_by_stretch(const nlohmann::json& factor) {
  return fmt::format(
      "with anchors at their prestress it bears {}, by limit analysis: it stands by what anchors take up as blocks "
      "move; state as failure_displacement_m what the structure may move",
      factor.is_null() ? "nothing of what the water presses"
                       : fmt::format("only {:.5g} times what the water presses", factor.get<double>()));
}

}  // namespace

void add_water_factor(const limit::LimitAnalysis& structure, Situation& now, const limit::Wrenches& stated,
                      const limit::LimitStrength& strength, nlohmann::json& answer) {
  if (!now.water) return;
  constexpr double matters = 0.99;
  const limit::Wrenches dry = limit::combined(statics::weights_of(now.scene), 1, stated);
  const limit::Wrenches water = statics::water_forces(now.scene, now.water->at(now.level_m));
  const auto found = attempt([&] { return structure.largest_factor(dry, water); });
  const WaterFactor at_yield = water_factor(found);
  WaterFactor at_prestress;
  if (!now.scene.bolts.empty()) {
    const scene::Scene unmoved = with_anchors_at_prestress(now.scene);
    at_prestress = water_factor(attempt([&] { return limit::LimitAnalysis(unmoved).largest_factor(dry, water); }));
  }
  const bool fails = answer.value("outcome", "") == "fails";  // no more is to be said of how near its end is
  const auto is_scarce = [&](const nlohmann::json& factor) {
    return !fails && factor.is_number() && factor >= 1 && factor < scarce_water_factor;
  };
  const bool lower =
      at_prestress && (!at_yield || (!at_yield->is_null() && or_zero(*at_prestress) < matters * or_zero(*at_yield)));
  if (at_yield) {
    answer["water_factor"] = {{"factor", *at_yield}};
    if (at_yield->is_number()) answer["water_factor"]["gap"] = found.value->gap;
  }
  if (lower) {
    answer["water_factor"] = {{"factor", *at_prestress}, {"with_anchors_at_yield", at_yield.value_or(nullptr)}};
    if (is_scarce(*at_prestress)) {
      answer["warnings"].push_back(near_its_end(
          or_zero(*at_prestress), " with anchors at their prestress, which bear more only as blocks move", strength));
      return;
    }
    if (!fails && or_zero(*at_prestress) < 1) answer["warnings"].push_back(stands_by_stretch(*at_prestress));
  }
  if (at_yield && is_scarce(*at_yield)) answer["warnings"].push_back(near_its_end(or_zero(*at_yield), "", strength));
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
  if (structure.is_exact() || !strains(now.scene)) return;
  const scene::Scene rigid = with_rigid_blocks(now.scene);
  const auto without = attempt([&] { return strength_if_lower(rigid, now, found, jumps_below); });
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
