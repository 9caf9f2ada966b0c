// SPDX-License-Identifier: GPL-3.0-or-later
// The water of a scene, the model that computes its pressure, and the exchange with that model.
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

/// Pressure on an overtopped crest: none; falling linearly from the head over the crest at the upstream edge to zero at
/// the downstream edge; or the full head.
enum class CrestPressure { none, triangular, full };

/// The source of the added water pressure in a pseudo-static earthquake: Westergaard's formula on upstream faces, or
/// the finite elements of [fluid] model = "reservoir".
enum class AddedWater { westergaard, reservoir };
inline const char* name_of(AddedWater by) {
  return by == AddedWater::westergaard ? "Westergaard" : "finite elements";
}

/// Uplift during an earthquake: as before it, or zero where a joint has opened, because water has no time to flow in.
enum class ShakenUplift { held, zero_where_open };

/// A sheet of ice on the reservoir; its thrust is spread over its thickness below the level.
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
  int elements_per_face = 20;        ///< interface elements on a fully wet edge
  double open_crack_width_m = 0.05;  ///< narrower gaps contain no open water; default: 2.5e-3 of the structure's size
  std::optional<bool> wets_ends;  ///< whether faces at the model's ends below the bed are wet; default: by their shape
  bool may_overtop = false;       ///< allows levels above the crest
  CrestPressure crest_pressure = CrestPressure::none;
  std::optional<Ice> ice;
  double earthquake_coefficient = 0;           ///< k_h for the added water pressure
  double earthquake_vertical_coefficient = 0;  ///< k_v for it, with AddedWater::reservoir
  AddedWater added_water = AddedWater::westergaard;
  ShakenUplift uplift_in_shaking = ShakenUplift::held;
  bool skip_unchanged = true;  ///< still water keeps its pressures while no level and no block has moved

  /// Whether a pseudo-static earthquake adds to the water's pressure.
  [[nodiscard]] bool is_shaken() const { return earthquake_coefficient != 0 || earthquake_vertical_coefficient != 0; }
  void leave_out_earthquake() { earthquake_coefficient = earthquake_vertical_coefficient = 0; }
  bool operator==(const Water&) const = default;
};

/// Control of the levels in an OpenFOAM run after its start. table: the water in a pool follows its table at once;
/// free: no control; inflow: water flows in at the end of the mesh.
enum class LevelControl { table, free, inflow };

enum class WaveKind { regular, solitary };

/// Regular waves enter at the upstream end of the mesh, which absorbs reflections; a solitary wave starts at time 0.
struct Wave {
  WaveKind kind = WaveKind::regular;
  double height_m = 0;
  double period_s = 0;  ///< regular waves only
  bool operator==(const Wave&) const = default;
};

/// [fluid] model = "openfoam": interFoam's mesh and steps. A "depth" is the largest depth of both pools.
struct OpenFoam {
  std::string own_case;  ///< a user's own case, a folder relative to the scene file; empty: written from the scene
  int processes = 1;
  bool reconstruct = false;  ///< merge the results of all ranks at the end
  int cells_in_depth = 40;
  std::optional<double> upstream_depths;  ///< width of open water upstream, in depths; default: 2, or to drawn water
  std::optional<double> downstream_depths;
  double freeboard_depths = 0.25;  ///< height of air above the highest level or block, in depths
  std::optional<double> floor_m;   ///< lower side of the mesh; default: the lowest ground that water can reach
  double air_density_kg_per_m3 = 1;
  double max_courant = 0.5;
  int steps_per_window = 1;  ///< at least; more if max_courant requires it
  LevelControl level_control = LevelControl::table;
  double move_tolerance = 1e-7;  ///< in depths: blocks are mapped to the cells anew once a corner has moved this far
  double rest_tolerance = 0;     ///< of the largest pressure: smaller changes count as rest, without a step; 0: never
  std::vector<std::vector<Point>> initial_water_m;  ///< outlines filled with water at time 0, besides the pools
  int initial_water_line = 0;                       ///< where the scene file states them
  std::optional<Wave> wave;
  bool operator==(const OpenFoam&) const = default;
};

/// Whether waves enter at the end of the mesh; a solitary wave is there at time 0 instead.
inline bool comes_in(const OpenFoam& o) {
  return o.wave && o.wave->kind == WaveKind::regular;
}

/// [fluid] model = "reservoir": finite elements of water that responds to accelerations. Equations: fluid/reservoir.
struct Reservoir {
  std::optional<double> upstream_wall_m;    ///< x of a wall that moves with the ground; none: the reservoir continues
  std::optional<double> downstream_wall_m;  ///< the same for the tailwater
  double element_ratio = 0.25;              ///< longest side of a triangle over the depth
  double move_tolerance = 1e-3;             ///< share of the depth: smaller movements do not change the mesh
  bool surface_waves = false;               ///< linear gravity waves; false: the surface stays level
  bool compressible = false;
  double sound_speed_m_per_s = 1440;
  double bottom_reflection = 1;  ///< share of a pressure wave that the ground reflects, for compressible water
  bool operator==(const Reservoir&) const = default;
};

/// [fluid] model = "column": water in a pipe of constant width that ends at the edge of a block. It serves to measure
/// the accuracy of the coupling schedules. Equations: fluid/column.
struct Column {
  static constexpr double gravity_m_per_s2 = 9.81;  ///< the scene's own gravity may be zero so that blocks do not fall
  int block = -1;
  int edge = -1;
  double length_m = 0;
  double head_m = 0;                       ///< of the water above the edge at time 0
  double rise_ratio = 0;                   ///< rise of the far end for unit displacement of the edge
  std::optional<double> cushion_pa_per_m;  ///< stiffness of a layer between edge and water; none: no layer
  int steps_per_window = 1;
  bool operator==(const Column&) const = default;
};

/// [fluid] model = "external": a program of the user, see bridge/kit.
struct External {
  std::vector<std::string> command;  ///< that starts it, in the scene's folder; empty: the user starts it by hand
  bool remembers = true;             ///< its pressures depend on the past, so it needs its own checkpoints
  bool operator==(const External&) const = default;
};

/// Order in which the two sides step: bridge/schedule/schedules.hpp.
enum class Schedule { serial, parallel, improved };

/// Pressures between two exchanges: solid/block/pressure_history.hpp.
enum class LoadInWindow { held, linear, quadratic };

/// What happens when the exchange produces energy, which is an instability: the run fails, or ends there with a result.
enum class EnergyGain { stop, report };

struct Coupling {
  Schedule schedule = Schedule::serial;
  LoadInWindow load_in_window = LoadInWindow::held;
  double window_s = 0.01;
  double longest_window_s = 0;  ///< while nothing moves; 0: all windows have length window_s
  bool skip_exchanges = true;   ///< no messages while no block moves and the water is at rest
  double timeout_s = 20;        ///< longest silence of the other side
  double open_timeout_s = 20;   ///< longest wait for the other side to connect
  /// Solves for the inertia of the displaced water together with the block's own: solid/step/added_mass_guard.hpp.
  bool added_mass_guard = true;
  std::optional<double> added_mass_limit;  ///< largest added mass over block mass of a run; default: what is stable
  EnergyGain on_energy_gain = EnergyGain::stop;
  bool operator==(const Coupling&) const = default;
};

}  // namespace blockweir::scene
