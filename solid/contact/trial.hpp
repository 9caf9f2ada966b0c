// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks as a step tries to move them, and how far a contact or a support has come apart in it.
#pragma once

#include <limits>
#include <vector>

#include "solid/block/motion.hpp"
#include "solid/contact/contact_point.hpp"
#include "solid/contact/interaction.hpp"
#include "solid/contact/support.hpp"

namespace blockweir::solid {

struct Trial {
  const std::vector<Block>& blocks;
  const std::vector<Placement>& start;        ///< at the start of the step
  const std::vector<Vector6>& increment;      ///< tried so far
  const std::vector<Turn>& turn;              ///< of the increments
  const std::vector<Placement>& placement;    ///< start plus increment
  const std::vector<Vector6>& past_velocity;  ///< velocity = velocity_factor * increment + past_velocity
  double velocity_factor = 0;                 ///< 1/s; 0 where velocities mean nothing
};

/// Edge of a contact at the trial: unit tangent, outward normal.
struct EdgeFrame {
  Point t;
  Point n;
  double length = 0;
};

EdgeFrame edge_frame(const Trial& trial, const ContactPoint& c);
/// Material point of the edge's part at that fraction of the edge.
Point edge_point(const ContactPoint& c, double fraction);

/// At the vertex and at its foot on the edge, in the edge's frame of normal and tangent; force and stiffness open.
Interaction interaction_of(const ContactPoint& c, const EdgeFrame& edge, double slip);
Interaction interaction_of(const Support& s);

/// (gap, slip) of a contact, or (x, y) of a support from its target [m], with increments within the step computed
/// without cancellation, for large penalties; `moved` sums the displacements of both points [m].
struct Separation {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  double moved = 0;
};

Separation separation_of(const Trial& trial, const ContactPoint& c, const EdgeFrame& edge);
Separation separation_of(const Trial& trial, const Support& s);

/// What cancellation leaves uncertain of a force p * separation, per p and metre moved.
constexpr double separation_round_off = 4 * std::numeric_limits<double>::epsilon();

}  // namespace blockweir::solid
