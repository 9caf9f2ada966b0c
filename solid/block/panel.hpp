// SPDX-License-Identifier: GPL-3.0-or-later
// A loaded piece of a block's outline and its force on the block (10)-(11).
#pragma once

#include "solid/block/motion.hpp"
#include "solid/block/pressure_load.hpp"

namespace blockweir::solid {

/// Part s_from..s_to (fractions) of edge `edge` of block `block`; linear pressure between its two nodes.
struct Panel {
  int block = 0;
  int edge = 0;
  double s_from = 0;
  double s_to = 1;
  double pressure_from_pa = 0;
  double pressure_to_pa = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(block, edge, s_from, s_to, pressure_from_pa, pressure_to_pa);
  }
};

/// The two nodes of a panel as material points, and the forces there (global axes, N per metre).
struct PanelForce {
  std::array<Point, 2> node;
  std::array<Point, 2> force;
};

inline PanelForce panel_force(const Block& block, const Placement& placement, const Panel& panel,
                              scene::NodalRule rule) {
  const Point& a = block.vertices[static_cast<std::size_t>(panel.edge)];
  const Point& b = block.vertices[(static_cast<std::size_t>(panel.edge) + 1) % block.vertices.size()];
  PanelForce result{.node = {a + panel.s_from * (b - a), a + panel.s_to * (b - a)}, .force = {}};
  const Point span = placement.vector(result.node[1] - result.node[0]);
  const Point inward(-span.y(), span.x());  // traction is -p n; length that of the panel, which may be zero
  const auto forces = nodal_forces(rule, 1, panel.pressure_from_pa, panel.pressure_to_pa);
  for (std::size_t i = 0; i < 2; ++i) result.force[i] = forces[i] * inward;
  return result;
}

/// Generalized force of a panel: from nodal forces to the block (11). Since the displacement is linear in position, the
/// lever rule between vertices equals the virtual work T^T f.
inline Vector6 generalized_force(const Placement& placement, const PanelForce& panel) {
  return placement.generalized(panel.force[0], panel.node[0]) + placement.generalized(panel.force[1], panel.node[1]);
}

}  // namespace blockweir::solid
