// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that move together as one body, and the surface on which they separate from the rest.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <utility>
#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Displacements of material points since given times.
class MovedSince {
 public:
  /// `displacement` and `time_s` of the scene's blocks at those times.
  MovedSince(const Solid& solid, const std::vector<Vector6>& displacement, const std::vector<double>& time_s);

  /// Displacement of a point [m, from the centroid], relative to the base.
  [[nodiscard]] Point operator()(int block, const Point& X) const;
  /// Displacements of a contact's two points [m], and of its vertex relative to its edge.
  [[nodiscard]] Point of_vertex(const ContactPoint& c) const;
  [[nodiscard]] Point of_foot(const ContactPoint& c) const;
  [[nodiscard]] Point apart(const ContactPoint& c) const { return of_vertex(c) - of_foot(c); }
  /// Largest displacement of a vertex [m].
  [[nodiscard]] double farthest(int block) const;
  /// Rotation of the block [rad].
  [[nodiscard]] double turned(int block) const;
  [[nodiscard]] const Solid& solid() const { return solid_; }

 private:
  [[nodiscard]] Point of_part(int block, int part, const Point& X) const;

  const Solid& solid_;
  const std::vector<Vector6>& displacement_;
  std::vector<Placement> then_;
  std::vector<Point> base_;  ///< displacement of the base
};

/// Relative motion of two blocks in contact [m].
struct PairMotion {
  double moved = 0;            ///< largest of a contact's two points
  double relative = 0;         ///< largest between them
  double slip = 0;             ///< the same for closed contacts
  double normal = 0;           ///< sum of normal forces [N per metre]
  Eigen::AlignedBox2d points;  ///< of contacts
};
using PairMotions = std::map<std::pair<int, int>, PairMotion>;
PairMotions pair_motions(const MovedSince& moved);

struct MovingBody {
  std::vector<int> blocks;                ///< in the order of the scene
  std::vector<std::pair<int, int>> left;  ///< (block of the body, block left behind)
};

/// The body that contains `block`: blocks whose common contacts separate by less than a tenth of their motion. If all
/// neighbours move, too, they belong to the body, until something is left behind: fixed blocks, those that supports
/// lead (`led`), blocks at rest, and those that moved less than half as far. Nothing is left behind in free fall.
MovingBody moving_body(const MovedSince& moved, const PairMotions& pairs, const std::vector<bool>& stands,
                       const std::vector<bool>& led, int block);

}  // namespace blockweir::solid
