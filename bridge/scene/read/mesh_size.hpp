// SPDX-License-Identifier: GPL-3.0-or-later
// The key mesh_size_m of a block, section or region: the size of its triangles.
#pragma once

#include <span>

#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

/// Reads the key into `size_m`. Only a deformable block takes it: `stiff` is "fixed", "rigid" or, for a deformable one,
/// null. `outline` (may be empty) limits the number of triangles.
void read_mesh_size(TableReader& table, Reading& reading, const char* stiff, std::span<const Point> outline,
                    double& size_m);

}  // namespace blockweir::scene
