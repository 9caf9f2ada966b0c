// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of the blocks' outlines open water reaches, from geometry alone.
#pragma once

#include <vector>

#include "bridge/scene/ground_ends.hpp"
#include "fluid/hydrostatic/wet_edges.hpp"

namespace blockweir::hydrostatic {

enum class Pool { upstream, downstream };

/// The blocks where they are, and what water beside them meets.
struct Structure {
  std::vector<std::vector<Point>> outlines;
  double open_crack_width_m = 0.05;  ///< narrower gaps carry no water
  scene::GroundEnds ground{};
  bool floats = false;  ///< there is water below the lowest block
};

struct WetFaces {
  std::vector<WetInterval> intervals;
  std::vector<Ring> region;  ///< the water's section: outer rings and holes
  bool breached = false;     ///< open water finds a way from one side of the structure to the other
  bool behind = false;       ///< it gets past below the wall on the crest, whether it finds a way out or not
};

/// The pool is what of the half plane under `level_m` is connected to the far left (upstream) or far right
/// (downstream) once the blocks, the ground beyond the model's ends, and all gaps narrower than the structure's
/// `open_crack_width_m` are taken out: the blocks grow by half that width, what they leave of the water is found, and
/// its boundary moves back onto them. A thin wall on the structure's highest point keeps the two pools apart: water
/// above the crest presses on faces up to the crest and not on the crest itself.
/// Half the model is looked at first, unless water is `expected_behind` the wall, which changes no bit of what is
/// found.
WetFaces wet_faces(const Structure& structure, Pool pool, double level_m, bool expected_behind = false);

/// The crest's corner on the pool's side: of all vertices that are as high as the highest but for a little, the one
/// nearest to the pool, so that a crest which tilts a little as the block moves stays the same crest.
Point crest_corner(const Structure& structure, Pool pool);
/// The structure's highest point.
double crest_m(const Structure& structure);

/// Of a pool that ends at the upright line through the middle of the crest.
WetFaces wet_faces_up_to_the_crest(const Structure& structure, Pool pool, double level_m);

/// Of water that stands as high on both sides: of one body wherever it is connected, also over the crest.
WetFaces wet_faces_of_both(const Structure& structure, double level_m);

}  // namespace blockweir::hydrostatic
