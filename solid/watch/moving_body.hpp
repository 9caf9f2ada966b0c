// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that move together as one body, and the surface on which they leave the others behind.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <utility>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Displacements of material points from where blocks were at given times.
class MovedSince {
 public:
  /// `displacement` and `time_s` of the scene's blocks then.
  MovedSince(const Solid& solid, const std::vector<Vector6>& displacement, const std::vector<double>& time_s);

  /// Of a point [m, from the centroid], against the base.
  [[nodiscard]] Point operator()(int block, const Point& X) const;
  /// Of a contact's two points [m], and of its vertex against its edge.
  [[nodiscard]] Point of_vertex(const ContactPoint& c) const;
  [[nodiscard]] Point of_foot(const ContactPoint& c) const;
  [[nodiscard]] Point apart(const ContactPoint& c) const { return of_vertex(c) - of_foot(c); }
  /// Farthest that a vertex has come [m].
  [[nodiscard]] double farthest(int block) const;
  /// Angle that the block has turned [rad].
  [[nodiscard]] double turned(int block) const;
  [[nodiscard]] const Solid& solid() const { return solid_; }

 private:
  [[nodiscard]] Point of_part(int block, int part, const Point& X) const;

  const Solid& solid_;
  const std::vector<Vector6>& displacement_;
  std::vector<Placement> then_;
  std::vector<Point> base_;  ///< what the base has moved
};

/// How two blocks in contact have moved [m].
struct PairMotion {
  double moved = 0;            ///< largest of a contact's two points
  double relative = 0;         ///< largest between them
  double slip = 0;             ///< the same of closed contacts
  double normal = 0;           ///< sum of normal forces [N per metre]
  Eigen::AlignedBox2d points;  ///< of contacts
};
using PairMotions = std::map<std::pair<int, int>, PairMotion>;
PairMotions pair_motions(const MovedSince& moved);

struct MovingBody {
  std::vector<int> blocks;                ///< in the scene's order
  std::vector<std::pair<int, int>> left;  ///< (block of the body, block left behind), where they meet
};

/// The body that `block` is a part of: blocks whose common contacts come apart by less than a tenth of what they move.
/// Where all that it touches moves, too, what touches it belongs to it, until something is left behind: what is fixed,
/// what stands, and what has come less than half the way along. Nothing is left behind where it falls free.
MovingBody moving_body(const MovedSince& moved, const PairMotions& pairs, const std::vector<bool>& stands, int block);

}  // namespace blockweir::solid
