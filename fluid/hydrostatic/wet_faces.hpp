// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the parts of the blocks' outlines that open water reaches, from geometry only.
#pragma once

#include <limits>
#include <vector>

#include "bridge/scene/ground_ends.hpp"
#include "fluid/hydrostatic/wet_edges.hpp"

namespace blockweir::hydrostatic {

enum class Pool { upstream, downstream };

/// The blocks at their positions, and other boundaries of the water.
struct Structure {
  std::vector<std::vector<Point>> outlines;
  double open_crack_width_m = 0.05;  ///< narrower gaps contain no water
  scene::GroundEnds ground{};
  bool floats = false;  ///< water is below the lowest block
  /// Where the scene draws the structure's highest point; NaN if no matter.
  double crest_drawn_m = std::numeric_limits<double>::quiet_NaN();
  /// Blocks that the crest belongs to; empty: all. A deck on supports of its own is none of them.
  std::vector<bool> retaining{};

  [[nodiscard]] bool is_retaining(std::size_t block) const { return retaining.empty() || retaining[block]; }
};

struct WetFaces {
  std::vector<WetInterval> intervals;
  std::vector<Ring> region;  ///< the water's section: outer rings and holes
  bool breached = false;     ///< open water connects both sides of the structure
  bool behind = false;       ///< it passes below the wall on the crest, whether it finds a way out or not
};

/// The pool is the part of the half plane below `level_m` that is connected to the far left (upstream) or
/// far right (downstream), without the blocks, the ground beyond the model's ends, and all gaps narrower
/// than `open_crack_width_m`. For that the blocks grow by half the width, the remaining water is found, and
/// its boundary moves back onto the blocks. A thin wall on the structure's highest point separates the two
/// pools: water above the crest presses on faces up to the crest, not on the crest itself. Only half the
/// model is searched first, unless water is `expected_behind` the wall; this does not change a bit of the
/// result.
WetFaces wet_faces(const Structure& structure, Pool pool, double level_m, bool expected_behind = false);

/// The crest's corner on the pool's side: of all vertices almost as high as the highest, the one nearest to the pool. A
/// crest that tilts a little as the block moves thus remains the same crest.
Point crest_corner(const Structure& structure, Pool pool);
/// The highest point of what retains the water.
double crest_m(const Structure& structure);

/// For a pool that ends at the vertical line through the middle of the crest.
WetFaces wet_faces_up_to_the_crest(const Structure& structure, Pool pool, double level_m);

/// For water with the same level on both sides: one body wherever it is connected, also over the crest.
WetFaces wet_faces_of_both(const Structure& structure, double level_m);

}  // namespace blockweir::hydrostatic
