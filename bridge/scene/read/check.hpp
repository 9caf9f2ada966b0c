// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of blocks against each other: overlaps, and blocks without any support.
#pragma once

#include "bridge/scene/read/problems.hpp"
#include "bridge/scene/scene.hpp"

namespace blockweir::scene {

/// Share of a block's size: coordinates in files are rounded, and blocks closer than this touch.
constexpr double rounding_ratio = 1e-6;

/// Whether two blocks overlap by more than 1e-6 of the smaller one's size.
bool overlap(const Block& a, const Block& b);

/// Reports blocks that overlap. Of blocks that two generators or sections make one error names the first pair and the
/// number of the others. Blocks without vertices are skipped.
void check_overlaps(const Scene& scene, Problems& problems);

/// Reports, in one error, the blocks that would fall for ever. A block is held if one of these is true: it is fixed; a
/// support holds a point of it in y; a bolt connects it to the ground or to a held block; its material is lighter than
/// the scene's water; it shares a boundary with a held block, or lies vertically above a part of one. Without gravity
/// no block falls.
void check_unsupported(const Scene& scene, Problems& problems);

}  // namespace blockweir::scene
