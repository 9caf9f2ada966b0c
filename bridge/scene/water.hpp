// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says of its water, of the model that computes its pressure, and of the exchange with that model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bridge/geometry/point.hpp"
#include "bridge/scene/fluid_models.hpp"
#include "bridge/scene/time_table.hpp"

namespace blockweir::scene {

using geometry::Point;

enum class NodalRule { consistent, lumped };
enum class Atmosphere { none, wet_faces };

/// Pressure on the crest of a structure that is overtopped, from its upstream edge to its downstream edge: left out,
/// that of the head over the crest falling linearly to zero, or all of that head.
enum class CrestPressure { none, triangular, full };

/// By whom water presses on a dam in a pseudo-static earthquake: Westergaard's formula on upstream faces, or the finite
/// elements of [fluid] model = "reservoir".
enum class AddedWater { westergaard, reservoir };
inline const char* name_of(AddedWater by) {
  return by == AddedWater::westergaard ? "Westergaard" : "finite elements";
}

/// Uplift while the ground shakes: as at rest, or none where a joint has opened, into which water has no time to flow.
enum class ShakenUplift { held, zero_where_open };

/// Of a sheet of ice on the reservoir, spread over its thickness under the level.
struct Ice {
  double thrust_n_per_m = 0;
  double thickness_m = 0;
  bool operator==(const Ice&) const = default;
};

struct Water {
  double density_kg_per_m3 = 1000;
  std::optional<TimeTable> upstream_level_m;
  std::optional<TimeTable> downstream_level_m;
  Atmosphere atmosphere = Atmosphere::none;
  double atmospheric_pressure_pa = 101300;
  NodalRule nodal_rule = NodalRule::consistent;
  int elements_per_face = 20;        ///< interface elements on an edge that is wet all along
  double open_crack_width_m = 0.05;  ///< narrower gaps carry no open water; read: 2.5e-3 of the structure's size
  std::optional<bool>
      wets_ends;             ///< do faces on the model's ends below the bed stand in water? Default: by their shape
  bool may_overtop = false;  ///< levels above the crest are meant
  CrestPressure crest_pressure = CrestPressure::none;
  std::optional<Ice> ice;
  double earthquake_coefficient = 0;           ///< k_h of the water's added pressure
  double earthquake_vertical_coefficient = 0;  ///< k_v of it, of AddedWater::reservoir
  AddedWater added_water = AddedWater::westergaard;
  ShakenUplift uplift_in_shaking = ShakenUplift::held;
  bool skip_unchanged = true;  ///< still water keeps its pressures while neither a level nor a block has moved
  bool operator==(const Water&) const = default;
};

/// Once an OpenFOAM run has begun: whether the fractions of a pool follow its table at once, nobody touches the water,
/// or it comes in at the mesh's end.
enum class LevelControl { table, free, inflow };

enum class WaveKind { regular, solitary };

/// Regular waves come in at the mesh's upstream end, which takes up what comes back; a solitary one sets out at time 0.
struct Wave {
  WaveKind kind = WaveKind::regular;
  double height_m = 0;
  double period_s = 0;  ///< regular waves only
  bool operator==(const Wave&) const = default;
};

/// [fluid] model = "openfoam": interFoam's mesh and steps. A depth is the largest that either pool reaches.
struct OpenFoam {
  std::string own_case;  ///< a user's own case, a folder relative to the scene file's; empty: it is written from here
  int processes = 1;
  bool reconstruct = false;  ///< put the ranks' results together at the end
  int cells_in_depth = 40;
  double upstream_depths = 2;  ///< of open water beside the structure
  double downstream_depths = 2;
  double freeboard_depths = 0.25;  ///< of air above the highest level or block
  std::optional<double> floor_m;   ///< the mesh's lower side; default: the lowest ground that water can reach
  double air_density_kg_per_m3 = 1;
  double max_courant = 0.5;
  int steps_per_window = 1;  ///< at least; more where max_courant asks for it
  LevelControl level_control = LevelControl::table;
  double move_tolerance = 1e-7;  ///< of the depth: blocks are cut out of the cells anew once a corner has gone so far
  double rest_tolerance = 0;  ///< of the largest pressure: what is less counts as rest, and no step is made; 0: never
  std::vector<std::vector<Point>> initial_water_m;  ///< outlines full of water at time 0, beside the pools
  std::optional<Wave> wave;
  bool operator==(const OpenFoam&) const = default;
};

/// Whether waves come in at the mesh's end; a solitary one is there at time 0.
inline bool comes_in(const OpenFoam& o) {
  return o.wave && o.wave->kind == WaveKind::regular;
}

/// [fluid] model = "reservoir": finite elements of water that answers accelerations. fluid/reservoir says its equation.
struct Reservoir {
  std::optional<double> upstream_wall_m;    ///< x of a wall that moves with the ground; none: the reservoir is long
  std::optional<double> downstream_wall_m;  ///< the same, of the tailwater
  double element_ratio = 0.25;              ///< longest side of a triangle over the depth
  double move_tolerance = 1e-3;             ///< of the depth: what has moved by less is where it was
  bool surface_waves = false;               ///< linear gravity waves; else the surface stays level
  bool compressible = false;
  double sound_speed_m_per_s = 1440;
  double bottom_reflection = 1;  ///< share of a pressure wave that the ground throws back, where compressible
  bool operator==(const Reservoir&) const = default;
};

/// [fluid] model = "column": water in a pipe of constant width that ends at the edge of a block, for schedules to be
/// measured by. fluid/column says its equations.
struct Column {
  static constexpr double gravity_m_per_s2 = 9.81;  ///< the scene's own may be off so that blocks do not fall
  int block = -1;
  int edge = -1;
  double length_m = 0;
  double head_m = 0;                       ///< of the water over the edge at time 0
  double rise_ratio = 0;                   ///< by how much the far end rises when the edge moves in by 1
  std::optional<double> cushion_pa_per_m;  ///< of what lies between edge and water; none: nothing does
  int steps_per_window = 1;
  bool operator==(const Column&) const = default;
};

/// [fluid] model = "external": a program that is not blockweir's, bridge/kit.
struct External {
  std::vector<std::string> command;  ///< that starts it, in the scene's folder; empty: it is started by hand
  bool remembers = true;             ///< its pressures depend on what has been, so that it needs checkpoints of its own
  bool operator==(const External&) const = default;
};

/// Who steps when: bridge/schedule/schedules.hpp.
enum class Schedule { serial, parallel, improved };

/// What becomes of the pressures between exchanges: solid/block/water_course.hpp.
enum class LoadInWindow { held, linear, quadratic };

/// What becomes of a run whose exchange makes energy, which is an instability: it fails, or it ends there as a result.
enum class EnergyGain { stop, report };

struct Coupling {
  Schedule schedule = Schedule::serial;
  LoadInWindow load_in_window = LoadInWindow::held;
  double window_s = 0.01;
  double longest_window_s = 0;  ///< while nothing moves; 0: all windows are window_s long
  bool skip_exchanges = true;   ///< nothing is said while no block moves and the water stands
  double timeout_s = 20;        ///< longest silence of a partner
  double open_timeout_s = 20;   ///< longest wait for it to arrive
  /// The inertia of water that a block pushes is solved for with the block's own: solid/step/added_mass_guard.hpp.
  bool added_mass_guard = true;
  std::optional<double> added_mass_limit;  ///< water over block, beyond which a run is refused; default: what is stable
  EnergyGain on_energy_gain = EnergyGain::stop;
  bool operator==(const Coupling&) const = default;
};

}  // namespace blockweir::scene
