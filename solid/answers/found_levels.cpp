// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/answers/found_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"
#include "bridge/scene/corner_stands.hpp"

namespace blockweir::solid {

using limit::Filled;

namespace {

constexpr const char* bonds_in_turn = "bonds break one after the other, and limit analysis lets all act at once";

std::string slips() {
  return "slips that add up to failure_displacement_m: limit analysis asks for equilibrium alone";
}

}  // namespace

double FoundLevels::off(const StaticLevel& found) const {
  return (found.level_m - limit.value->level_m) / (limit.value->level_m - empty_m);
}

bool FoundLevels::agrees(const StaticLevel& found) const {
  constexpr double same = 1e-5;  // the blocks' strain and what their slips add up to before they rest come to less
  return found.outcome == limit.value->outcome && (found.outcome != Filled::fails || std::abs(off(found)) <= same);
}

std::optional<double> FoundLevels::rigid_level() const {
  if (!rigid.value || rigid.value->outcome != Filled::fails) return std::nullopt;
  return rigid.value->level_m;
}

/// Do blocks that do not strain fail at a level that the blocks are said to bear?
bool FoundLevels::rigid_fails_lower() const {
  constexpr double strain = 1e-3;  // effect of strain on a level, relative to the rise
  return rigid_level() && *rigid_level() < blocks.value->level_m - strain * (blocks.value->level_m - empty_m);
}

bool FoundLevels::agree() const {
  return blocks.value && limit.value && blocks.value->stopped.empty() && !blocks.value->slow_rise &&
         !rigid_fails_lower() && agrees(*blocks.value);
}

/// Do the blocks fail at a lower level than by limit analysis?
bool FoundLevels::is_lower() const {
  return blocks.value->outcome == Filled::does_not_stand_empty ||
         (blocks.value->outcome == Filled::fails && off(*blocks.value) < 0);
}

std::string FoundLevels::reason() const {
  if (agree()) return strains(scene) ? "strain, and the width of the search" : "the width of the search";
  if (!blocks.value || !limit.value) return "none is known: only one of the two has an answer";
  if (!blocks.value->stopped.empty()) return "none is known: the blocks' level is known to level_width_m alone";
  const std::string rigid_too =
      rigid_fails_lower() ? fmt::format("blocks that do not strain fail at {:.6g} m", rigid.value->level_m) : "";
  if (blocks.value->slow_rise) return of_friction_history() + (rigid_too.empty() ? "" : "; " + rigid_too);
  if (!rigid_too.empty()) {
    return "history of joint forces: the level depends on how the friction in the joints came about; " + rigid_too +
           ", the others bear more";
  }
  if (rigid.value && agrees(*rigid.value)) return of_deformation();
  return of_an_upper_bound();
}

std::string FoundLevels::of_friction_history() const {
  const StaticLevel::SlowRise& rise = *blocks.value->slow_rise;
  return fmt::format(
      "history of joint forces: the level depends on how the friction in the joints came about; all loads at once "
      "fail at {:.6g} m, under a level that rises slowly the blocks {} {:.6g} m",
      blocks.value->level_m, rise.outcome == Filled::fails ? "fail at" : "stand up to", rise.level_m);
}

std::string FoundLevels::of_deformation() const {
  const char* rigid_blocks = rigid.value->outcome == Filled::fails ? "fail at the level of limit analysis"
                             : rigid.value->outcome == Filled::stands_full
                                 ? "stand at every level, as by limit analysis"
                                 : "do not stand empty, as by limit analysis";
  const bool in_turn = is_lower() && has_bonds(scene);
  return fmt::format("deformation: blocks that do not strain {}{}{}", rigid_blocks,
                     in_turn ? "; as blocks strain, " : "", in_turn ? bonds_in_turn : "");
}

std::string FoundLevels::of_an_upper_bound() const {
  if (limit.value->outcome == Filled::does_not_stand_empty) {
    return "blocks that move before they rest: limit analysis takes the structure as it is drawn, where faces that "
           "do not touch hold nothing; no uplift acts between them, and the blocks' level is without it; let faces "
           "touch";
  }
  if (const auto stands = scene::corner_stands(scene); !stands.empty()) {
    return fmt::format(
        "block \"{}\" stands on one corner: any push turns it over, and the blocks tell a small one from none only "
        "roughly",
        scene.blocks[at(stands[0].block)].name);
  }
  const bool lower = is_lower();
  // Before the slips: they add up because the anchors have not yet stretched to their yield.
  if (lower && !any_force && yields_above_prestress(scene)) {
    return std::string(yields_note) + (blocks.value->slips_add_up ? "; " + slips() : "");
  }
  if (lower && blocks.value->slips_add_up) {
    return slips();
  }
  if (lower && any_force) return std::string(anchors_note) + "; the blocks' own bolts stretch";
  if (lower && has_bonds(scene)) {
    return std::string("history of joint forces: ") + bonds_in_turn;
  }
  const auto any_joint = [this](auto has) {
    const auto of = [&](const scene::Joint& joint) { return has(joint.law); };
    return has(scene.default_joint) || std::any_of(scene.joints.begin(), scene.joints.end(), of);
  };
  if (lower && any_joint([](const auto& law) { return law.has_flow(); })) {
    return "joints with uplift = \"flow\" that open and fill: limit analysis takes joints as they are drawn";
  }
  if (lower && any_joint([](const auto& law) { return law.bends(); })) {
    return "rough joints, whose friction falls with the stress: the blocks take the stress at each end of a joint, "
           "limit analysis its mean over the joint";
  }
  if (lower) {
    return "friction without dilation: limit analysis takes joints to open as they slip, and is an upper bound";
  }
  return "none is known: limit analysis is an upper bound of rigid blocks";
}

}  // namespace blockweir::solid
