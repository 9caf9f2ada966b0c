// SPDX-License-Identifier: GPL-3.0-or-later
// The fluid models that a scene can choose: one row each.
#pragma once

#include <algorithm>
#include <array>

namespace blockweir::scene {

enum class FluidModel { none, hydrostatic, reservoir, openfoam, column, external };

struct FluidEntry {
  FluidModel model;
  const char* key;                ///< [fluid] model = "key"
  const char* name;               ///< in messages
  const char* program = nullptr;  ///< that computes it; null: no program
  const char* about = "";         ///< what the program computes, for its --help
  const char* role = "";          ///< its name in the handshake, and of its log and checkpoints
  const char* folder = "";        ///< its own folder within the run's folder
  bool still_pools = false;       ///< levels follow their tables, and wet faces follow from geometry
  bool remembers = false;         ///< its pressures depend on the past: it needs its own checkpoint to resume
  bool yours = false;             ///< a program of the user: [fluid.external] command
  bool reads_files = false;       ///< reads files that the scene names
  double timeout_s = 20;          ///< default: the longest that the solid waits for a message
};

inline constexpr std::array fluid_models = {
    FluidEntry{.model = FluidModel::none, .key = "none", .name = "none"},
    FluidEntry{.model = FluidModel::hydrostatic,
               .key = "hydrostatic",
               .name = "hydrostatic",
               .program = "blockweir-hydrostatic",
               .about = "still water that presses on the blocks of a scene",
               .role = "hydrostatic",
               .still_pools = true},
    FluidEntry{.model = FluidModel::reservoir,
               .key = "reservoir",
               .name = "reservoir",
               .program = "blockweir-reservoir",
               .about = "still water that answers accelerations, by finite elements",
               .role = "reservoir",
               .still_pools = true,
               .remembers = true},
    FluidEntry{.model = FluidModel::openfoam,
               .key = "openfoam",
               .name = "OpenFOAM",
               .program = "blockweir-openfoam",
               .about = "water that moves, by OpenFOAM's interFoam",
               .role = "openfoam",
               .folder = "openfoam",
               .remembers = true,
               .reads_files = true,
               .timeout_s = 120},  // interFoam makes its mesh before it connects, and may need many steps in a window
    FluidEntry{.model = FluidModel::column,
               .key = "column",
               .name = "column",
               .program = "blockweir-column",
               .about = "a pipe of water at the edge of a block",
               .role = "column",
               .remembers = true},
    FluidEntry{.model = FluidModel::external,
               .key = "external",
               .name = "external",
               .role = "external",
               .folder = "external",
               .remembers = true,  // unless the scene says otherwise
               .yours = true,
               .timeout_s = 60},
};

constexpr const FluidEntry& fluid_entry(FluidModel model) {
  return *std::find_if(fluid_models.begin(), fluid_models.end(), [&](const FluidEntry& e) { return e.model == model; });
}

constexpr bool still_pools(FluidModel model) {
  return fluid_entry(model).still_pools;
}

/// Name for messages.
constexpr const char* name(FluidModel model) {
  return fluid_entry(model).name;
}

}  // namespace blockweir::scene
