// SPDX-License-Identifier: GPL-3.0-or-later
// The moving parts: each block of the scene, or, for a block with a mesh, its triangles.
#pragma once

#include <vector>

#include "solid/block/contact_outlines.hpp"
#include "solid/block/panel.hpp"

namespace blockweir::solid {

/// A straight side of a block's outline, and the part that it belongs to.
struct OutlineSide {
  int part = 0;
  int edge = 0;            ///< of the part, from its vertex of this number to the next
  int described_edge = 0;  ///< of the scene's block; the fractions are those of this edge
  double s_from = 0;
  double s_to = 1;
};

/// Coupling of two triangles with a common side: strain energy e_i . stiffness e_j.
struct StrainCoupling {
  int i = 0;
  int j = 0;
  Eigen::Matrix3d stiffness;  ///< N per metre
};

/// A material point of a part.
struct Anchor {
  int part = 0;
  Point material;  ///< m, relative to the part's centroid
};

struct MovingParts {
  std::vector<Block> blocks;                       ///< the scene's blocks in its order; then all triangles
  std::vector<std::vector<OutlineSide>> outlines;  ///< of the scene's blocks
  std::vector<ContactOutline> contact_outlines;    ///< the same, as contacts see them
  std::vector<std::vector<int>> triangles;         ///< of the scene's blocks; empty without a mesh
  std::vector<StrainCoupling> couplings;
  int nodes = 0;  ///< of all meshes

  /// The ends of a side, as material points of its part.
  [[nodiscard]] const Point& vertex(const OutlineSide& side) const { return corner(side, 0); }
  [[nodiscard]] const Point& end(const OutlineSide& side) const { return corner(side, 1); }
  /// The part of scene block `block` that contains the point, or is nearest to it.
  [[nodiscard]] Anchor anchor(int block, const Point& point) const;
  /// Divides a panel of a scene block into panels of its parts and appends them to `panels`.
  void split(const Panel& panel, std::vector<Panel>& panels) const;

 private:
  [[nodiscard]] const Point& corner(const OutlineSide& side, std::size_t further) const {
    const auto& vertices = blocks[static_cast<std::size_t>(side.part)].vertices;
    return vertices[(static_cast<std::size_t>(side.edge) + further) % vertices.size()];
  }
};

/// Triangles have linear displacements. Their strains are smoothed over the domains of sides, each a third of the
/// adjacent triangles (edge-based smoothed finite elements, Liu, Nguyen-Thoi and Lam 2009); unsmoothed triangles would
/// be too stiff in bending.
MovingParts make_moving_parts(const scene::Scene& scene);

}  // namespace blockweir::solid
