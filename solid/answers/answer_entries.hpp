// SPDX-License-Identifier: GPL-3.0-or-later
// Entries that the answers of `level` and `safety` share.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "solid/limit/mechanism_description.hpp"

namespace blockweir::solid {

/// The result of one of the two methods, or the reason why it has none. The other method's result is kept in any case.
template <class T>
struct Attempt {
  std::optional<T> value;
  std::string why_not;
};

/// A std::runtime_error means that the method finds nothing; errors of the scene are thrown on.
template <class Way>
auto attempt(Way way) -> Attempt<decltype(way())> {
  try {
    return {way(), {}};
  } catch (const std::runtime_error& error) {
    return {std::nullopt, error.what()};
  }
}

/// For bolts without yield_n_per_m: limit analysis does not know their elongation.
inline constexpr const char* anchors_note =
    "in limit analysis anchors hold any force: state yield_n_per_m of each [[bolt]]";

/// For bolts that yield above their prestress.
inline constexpr const char* yields_note =
    "limit analysis takes anchors at their yield force, which the blocks' anchors reach only as they stretch";

/// For a factor at which blocks wedge each other.
inline constexpr const char* jams_note =
    "blocks wedge each other at this bound: with a little more friction they would bear any load, by forces that grow "
    "without limit; real joints slip without opening so much, and the blocks' factor shows what they bear";
/// Adds to the notes on limit analysis.
void add_note(const char* note, nlohmann::json& answer);

/// Whether a bolt yields above its prestress, by more than a hundredth.
bool yields_above_prestress(const scene::Scene& scene);

/// Prints a line of progress if the linear programs will take long.
void announce_limit_analysis(const limit::LimitAnalysis& structure);
/// Adds "upper_bound", and "limit_analysis_note" on what the user has left open.
void add_what_limit_analysis_takes(const limit::LimitAnalysis& structure, nlohmann::json& answer);

/// Describes a mechanism, with the motion of each block that moves.
nlohmann::json mechanism_json(const limit::LimitAnalysis& structure, const limit::Twists& mechanism);

/// Adds the source of the added water pressure in an earthquake, if the scene has one.
void add_water_in_an_earthquake(const scene::Scene& scene, nlohmann::json& answer);

/// Warns that a static answer neglects ground motion and incoming waves, if the scene has them.
void add_motion_left_out(const scene::Scene& scene, nlohmann::json& answer);

/// Says that the blocks' answer has supports where they are led to, if the scene moves any.
void add_moved_supports(const scene::Scene& scene, nlohmann::json& answer);

/// Whether some joint has a bond that slip or tension can break: cohesion, tension strength or a peak friction.
bool has_bonds(const scene::Scene& scene);

/// Whether some moving block is deformable.
bool strains(const scene::Scene& scene);
/// The same scene with rigid blocks.
scene::Scene with_rigid_blocks(scene::Scene scene);

}  // namespace blockweir::solid
