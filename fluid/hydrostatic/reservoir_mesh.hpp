// SPDX-License-Identifier: GPL-3.0-or-later
// Linear triangles of a pool's section. Its nodes on blocks are those of the interface elements.
#pragma once

#include <array>
#include <vector>

#include "fluid/hydrostatic/wet_faces.hpp"

namespace blockweir::hydrostatic {

/// An interface element's two nodes.
using InterfaceElement = std::array<Point, 2>;

struct ReservoirMesh {
  std::vector<Point> node;
  std::vector<std::array<std::size_t, 3>> triangle;  ///< nodes, counter-clockwise
};

/// Constrained Delaunay triangulation of `region` (rings, including holes), with a lattice of nodes `size_m` apart
/// inside. Interface elements within `near_m` of the region's boundary become unsplit edges of the mesh; the rest of
/// the boundary is divided into pieces of about size_m. Limited to 50,000 nodes: size_m grows instead.
ReservoirMesh mesh_reservoir(const std::vector<Ring>& region, const std::vector<InterfaceElement>& interface,
                             double size_m, double near_m);

}  // namespace blockweir::hydrostatic
