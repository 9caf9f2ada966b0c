// SPDX-License-Identifier: GPL-3.0-or-later
// The key mesh_size_m of a block, a section or a region: how finely the solid triangulates it.
#pragma once

#include <span>

#include "bridge/scene/read/reading.hpp"

namespace blockweir::scene {

/// Reads it into `size_m`. What is "fixed" or "rigid" (else `stiff` is null) takes none; `outline` (may be empty)
/// bounds the number of triangles.
void read_mesh_size(TableReader& table, Reading& reading, const char* stiff, std::span<const Point> outline,
                    double& size_m);

}  // namespace blockweir::scene
