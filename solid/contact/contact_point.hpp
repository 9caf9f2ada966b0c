// SPDX-License-Identifier: GPL-3.0-or-later
// One vertex of a block's outline against one edge of another's.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "solid/contact/joint_law.hpp"

namespace blockweir::solid {

/// What it keeps from step to step, and an equilibrium changes.
struct ContactMemory {
  Eigen::Vector2d multiplier = Eigen::Vector2d::Zero();  ///< (normal, shear) force on the vertex [N per metre]
  Eigen::Vector2d force = Eigen::Vector2d::Zero();       ///< what acts: multiplier less penalty times separation
  double penalty = 0;                                    ///< N/m per metre
  double bond_length = 0;                                ///< m, part of the joint that was bonded at the start
  double bond = 0;                                       ///< remaining share of cohesion and tension strength
  double slip_m = 0;                                     ///< signed sum of slip along the edge
  double slip_path_m = 0;                                ///< sum of its magnitude
  double gap_at_start = 0;    ///< m between blocks that touch but for rounded coordinates: counts as none
  double overlap_m = 0;       ///< not above zero: by so much more than its spring gives way blocks are in each other
  double stored_j_per_m = 0;  ///< in its spring
  ContactState state = ContactState::open;
  bool let_go = false;  ///< the bond does not act in this step: open at its start, or pulled off

  [[nodiscard]] bool bonded() const { return bond > 0; }
  /// Has it ever? The slip of its joint counts from then on.
  [[nodiscard]] bool has_touched() const { return bond_length > 0 || slip_path_m > 0; }
};

struct ContactPoint : ContactMemory {
  // Who: constant while the contact lasts.
  int law = 0;  ///< index into the model's joint laws
  int vertex_block = 0;
  int vertex = 0;
  int edge_block = 0;
  int edge = 0;
  // The parts of those blocks that meet, with the material points of vertex and edge on them.
  int vertex_part = 0;
  int edge_part = 0;
  Eigen::Vector2d vertex_at = Eigen::Vector2d::Zero();
  Eigen::Vector2d edge_from = Eigen::Vector2d::Zero();
  Eigen::Vector2d edge_to = Eigen::Vector2d::Zero();

  // Geometry at the start of the step.
  double anchor = 0;                                     ///< fraction along the edge from which slip is measured
  Eigen::Vector2d separation = Eigen::Vector2d::Zero();  ///< vertex minus anchor point [m]
  double gap = 0;                                        ///< normal part of it [m], negative: penetration
  double length = 0;                                     ///< m of joint that the contact stands for
  double elastic_slip = 0;                               ///< m of the step's slip that a contact spring gives back
  bool slid = false;                                     ///< in a step of the window at hand

  /// The two blocks, low index first.
  [[nodiscard]] std::pair<int, int> pair() const { return std::minmax({vertex_block, edge_block}); }

  [[nodiscard]] bool same_key(const ContactPoint& other) const {
    return vertex_block == other.vertex_block && vertex == other.vertex && edge_block == other.edge_block &&
           edge == other.edge;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(vertex_block, vertex, edge_block, edge, vertex_part, edge_part, vertex_at, edge_from, edge_to, law, anchor,
            separation, gap, length, multiplier, force, penalty, bond_length, bond, state, slip_m, slip_path_m,
            gap_at_start, overlap_m, stored_j_per_m, elastic_slip, slid);
  }
};

}  // namespace blockweir::solid
