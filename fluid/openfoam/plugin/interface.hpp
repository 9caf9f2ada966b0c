// SPDX-License-Identifier: GPL-3.0-or-later
// constant/blockweir, read: what the case's writer told the plugin of the scene.
#pragma once

#include <IOdictionary.H>
#include <fvMesh.H>

#include <optional>

#include "bridge/scene/uplift.hpp"
#include "bridge/wire/message.hpp"
#include "fluid/openfoam/polygon_clip.hpp"

namespace blockweir::openfoam {

using Foam::word;  // OpenFOAM's macro TypeName speaks of it

struct InterfaceBlock {
  Polygon vertices;  ///< the scene's
  Polygon outline;   ///< what stands in the mesh: the same, but for the ground, which is drawn out beyond it
  Point centroid;    ///< of the scene's outline
  bool loaded = true;
  bool movable = true;
};

/// A face of a crack: fractions along the block's edge, and along the crack.
struct CrackPanel {
  int block = 0;
  int edge = 0;
  double s_from = 0;
  double s_to = 1;
  double t_from = 0;
  double t_to = 1;
};

/// Where a crack meets open water, as a point of a block in the scene's outline, and which way that water lies.
struct CrackOpening {
  int block = 0;
  Point point;
  Point direction;
};

struct Crack {
  scene::Uplift law = scene::Uplift::none;
  scene::KnownHeads known;
  double length_m = 0;
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
  std::optional<double> cell_m;  ///< side of a cell beside blocks; none: it is measured
  bool own_case = false;         ///< a user's, not written from the scene
  double water_density = 0;
  double gravity = 0;  ///< m/s2, downwards
  double depth_m = 0;  ///< largest, of the water
  double open_crack_width_m = 0;
  double move_tolerance = 0;  ///< of the depth
  double rest_tolerance = 0;  ///< of the pressure at that depth; 0: the water never counts as at rest
  std::vector<InterfaceBlock> blocks;
  std::vector<Crack> cracks;
  bool flow_in_joints = false;  ///< constant/blockweirJoints tells of it
};

/// Ends the run through OpenFOAM's FatalIOError where an entry is missing or malformed.
Interface read_interface(const Foam::dictionary& dict);

}  // namespace blockweir::openfoam
