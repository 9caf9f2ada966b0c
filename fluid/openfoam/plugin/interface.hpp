// SPDX-License-Identifier: GPL-3.0-or-later
// Reads constant/blockweir: the scene data from the case's writer.
#pragma once

#include <IOdictionary.H>
#include <fvMesh.H>

#include <optional>

#include "bridge/scene/uplift.hpp"
#include "bridge/wire/message.hpp"
#include "fluid/openfoam/polygon_clip.hpp"

namespace blockweir::openfoam {

using Foam::word;  // required by OpenFOAM's macro TypeName

struct InterfaceBlock {
  Polygon vertices;  ///< the scene's
  Polygon outline;   ///< in the mesh: the same, except that the ground extends beyond the mesh
  Point centroid;    ///< of the outline as drawn
  bool loaded = true;
  bool movable = true;
};

/// A face of a crack: fractions along the block's edge and along the crack.
struct CrackPanel {
  int block = 0;
  int edge = 0;
  double s_from = 0;
  double s_to = 1;
  double t_from = 0;
  double t_to = 1;
};

/// The mouth of a crack at open water: a point of a block as drawn, and the direction of the water.
struct CrackOpening {
  int block = 0;
  Point point;
  Point direction;
};

struct Crack {
  scene::Uplift law = scene::Uplift::none;
  scene::KnownHeads known;
  double length_m = 0;
  std::vector<scene::Bend> bends;
  CrackOpening mouth;
  CrackOpening end;
  std::vector<CrackPanel> panels;
};

struct Interface {
  std::string endpoint;
  std::string keys;       ///< folder; empty: none
  bool insecure = false;  ///< none on a network
  double timeout_s = 0;
  double open_timeout_s = 0;
  wire::Hello hello;
  int steps_per_window = 1;
  double max_courant = 1;
  std::optional<double> cell_m;  ///< side of a cell beside blocks; none: to be measured
  bool own_case = false;         ///< a user's, not written from the scene
  double water_density = 0;
  double gravity = 0;  ///< m/s2, downwards
  double depth_m = 0;  ///< largest, of the water
  double open_crack_width_m = 0;
  double move_tolerance = 0;  ///< of the depth
  double rest_tolerance = 0;  ///< of the pressure at that depth; 0: the water never counts as at rest
  std::vector<InterfaceBlock> blocks;
  std::vector<Crack> cracks;
  bool flow_in_joints = false;  ///< its data is in constant/blockweirJoints
};

/// Ends the run through OpenFOAM's FatalIOError if an entry is missing or malformed.
Interface read_interface(const Foam::dictionary& dict);

}  // namespace blockweir::openfoam
