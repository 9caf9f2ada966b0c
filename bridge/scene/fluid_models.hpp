// SPDX-License-Identifier: GPL-3.0-or-later
// The fluids that a scene can have: one row each.
#pragma once

#include <algorithm>
#include <array>

namespace blockweir::scene {

enum class FluidModel { none, hydrostatic, reservoir, openfoam, column, external };

struct FluidEntry {
  FluidModel model;
  const char* key;                ///< [fluid] model = "key"
  const char* name;               ///< in messages
  const char* program = nullptr;  ///< that computes it; null: none is needed
  const char* about = "";         ///< what the program computes, for its --help
  const char* role = "";          ///< as which it greets the solid, and by which its log and checkpoints are named
  const char* folder = "";        ///< of its own within the run's
  bool still_pools = false;       ///< levels are those of their tables, and what is wet follows from geometry
  bool remembers = false;         ///< its pressures depend on what has been: it goes on from a checkpoint of its own
  bool yours = false;             ///< a program of the user's computes it: [fluid.external] command
  bool reads_files = false;       ///< that the scene names, beside the scene's text
  double timeout_s = 20;          ///< for which the solid waits for a sign of life, by default
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
               .timeout_s = 120},  // interFoam makes its mesh before it comes, and may have many steps in a window
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

/// As messages call it.
constexpr const char* name(FluidModel model) {
  return fluid_entry(model).name;
}

}  // namespace blockweir::scene
