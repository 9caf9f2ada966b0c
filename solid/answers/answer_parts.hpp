// SPDX-License-Identifier: GPL-3.0-or-later
// What answers of level and of safety have in common.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "solid/limit/mechanism_description.hpp"

namespace blockweir::solid {

/// What one of two ways has found, or why it has not: the other's answer stands for itself.
template <class T>
struct Attempt {
  std::optional<T> value;
  std::string why_not;
};

/// std::runtime_error is what a way does not find; what is wrong with the scene is thrown on.
template <class Way>
auto attempt(Way way) -> Attempt<decltype(way())> {
  try {
    return {way(), {}};
  } catch (const std::runtime_error& error) {
    return {std::nullopt, error.what()};
  }
}

/// Of bolts without yield_n_per_m: limit analysis knows no stretch.
inline constexpr const char* anchors_note =
    "in limit analysis anchors hold any force: state yield_n_per_m of each [[bolt]]";

/// Of bolts that yield above their prestress.
inline constexpr const char* yields_note =
    "limit analysis takes anchors at their yield force, which the blocks' anchors reach only as they stretch";
/// Has some bolt a yield above its prestress?
bool yields_above_prestress(const scene::Scene& scene);

/// A line of progress where the linear programs will take their time.
void tell_limit_analysis(const limit::LimitAnalysis& structure);
/// Adds "upper_bound", and a "limit_analysis_note" on what the user has left open.
void add_what_limit_analysis_takes(const limit::LimitAnalysis& structure, nlohmann::json& answer);

/// In words, with the motion of each block that moves.
nlohmann::json mechanism_json(const limit::LimitAnalysis& structure, const limit::Twists& mechanism);

/// Says after whom the water answers to an earthquake, where the scene has one.
void add_water_in_an_earthquake(const scene::Scene& scene, nlohmann::json& answer);

/// Warns that a static answer leaves out how the ground shakes and the waves that come, where they do.
void add_motion_left_out(const scene::Scene& scene, nlohmann::json& answer);

/// Has some joint a bond that slip or tension can break: cohesion, tension strength, a peak friction?
bool has_bonds(const scene::Scene& scene);

/// Does some block that can move strain?
bool strains(const scene::Scene& scene);
/// The same scene with rigid blocks.
scene::Scene with_rigid_blocks(scene::Scene scene);

}  // namespace blockweir::solid
