// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of the blocks' outlines open water reaches, from geometry alone.
#pragma once

#include <vector>

#include "fluid/hydrostatic/sideways.hpp"

namespace blockweir::hydrostatic {

enum class Pool { upstream, downstream };

/// Part of an edge of a block, fractions 0..1 along the edge.
struct WetInterval {
  int block = 0;
  int edge = 0;
  double s_from = 0;
  double s_to = 1;
};

struct WetFaces {
  std::vector<WetInterval> intervals;
  std::vector<Ring> region;  ///< the pool's section: outer rings and holes
  bool breached = false;     ///< open water finds a way from one side of the structure to the other
  bool behind = false;       ///< it gets past below the wall on the crest, whether it finds a way out or not
};

/// The pool is what of the half plane under `level_m` is connected to the far left (upstream) or far right
/// (downstream) once the blocks, and all gaps between them narrower than `open_crack_width_m`, are taken out: the
/// blocks grow by half that width, what they leave of the water is found, and its boundary moves back onto them.
/// A thin wall on the structure's highest point keeps the two pools apart: water above the crest presses on faces
/// up to the crest and not on the crest itself.
/// Half the model is looked at first, unless water is `expected_behind` the wall, which changes no bit of what is
/// found.
WetFaces wet_faces(const std::vector<std::vector<Point>>& outlines, Pool pool, double level_m,
                   double open_crack_width_m, bool expected_behind = false);

}  // namespace blockweir::hydrostatic
