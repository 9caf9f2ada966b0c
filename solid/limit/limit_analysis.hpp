// SPDX-License-Identifier: GPL-3.0-or-later
// Limit analysis of rigid blocks by linear programming. Static theorem: the largest factor on the live loads for which
// forces at the two ends of each face balance every block,
//   sum of forces and moments = 0,  N_i >= -T L/2,  |S| <= (c L + (N_1 + N_2) tan(phi))/reduction.
// Kinematic theorem, its dual: the mechanism whose resistance, less the power of dead loads, over the power of live
// loads is the same factor. Flow is associated: what slips opens by tan(phi)/reduction of it. So the factor is an upper
// bound where friction is Coulomb's.
#pragma once

#include <optional>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/limit/connections.hpp"
#include "solid/limit/twist.hpp"

namespace blockweir::solid::limit {

enum class Bearing { fails_at_a_factor, bears_any, bears_none };

struct LargestFactor {
  Bearing bearing = Bearing::bears_none;
  double factor = 0;
  Twists mechanism;  ///< of the structure at its limit; its fastest vertex has the velocity 1
  double gap = 0;    ///< of the mechanism's own factor to that of the forces, relative
};

/// By how much strength falls short of loads: the least force by which the shear strength of every face would have to
/// be larger, over the structure's weight.
struct Shortage {
  double ratio = 0;
  double per_reduction = 0;  ///< its derivative
  Twists mechanism;          ///< as above; zero where nothing is short
};

/// A corner in a kink of another block holds in a point, whatever the force. A real one is crushed.
enum class Kinks { hold, give_way };

class LimitAnalysis {
 public:
  /// Throws std::invalid_argument where no block can move. The scene must outlive it.
  explicit LimitAnalysis(const scene::Scene& scene, Kinks kinks = Kinks::hold);

  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  [[nodiscard]] const std::vector<Point>& centroids() const { return centroids_; }

  /// Else factors and levels are upper bounds where friction is Coulomb's.
  [[nodiscard]] bool is_exact() const { return is_exact_; }
  /// Bolts without a yield strength: they hold whatever would stretch them.
  [[nodiscard]] bool holds_any_force() const;
  /// Has some face friction or cohesion?
  [[nodiscard]] bool has_shear_strength() const;

  /// Of `live` beside `dead`, from 0 up.
  [[nodiscard]] LargestFactor largest_factor(const Wrenches& dead, const Wrenches& live) const;
  [[nodiscard]] bool bears(const Wrenches& loads) const;
  /// Nothing where no shear strength would do, as of what overturns.
  [[nodiscard]] std::optional<Shortage> shortage(const Wrenches& loads, double reduction) const;

  /// How a structure begins to move that cannot bear its loads, with the shear strength it has or, `however_strong`,
  /// with any: of all mechanisms the one with the most power over the sum of its velocities.
  [[nodiscard]] Twists collapse(const Wrenches& loads, bool however_strong) const;

  /// Power that faces and bolts take up in a mechanism that opens as it slips by the associated rule, at least.
  [[nodiscard]] double resistance(const Twists& mechanism, double reduction = 1) const;
  /// Velocity of face.b against face.a at a point.
  [[nodiscard]] Point jump(const Face& face, const Twists& mechanism, const Point& place) const;

 private:
  class Program;
  [[nodiscard]] Point velocity(int block, const Twists& mechanism, const Point& place) const;
  /// The fastest vertex gets the velocity 1.
  void normalize(Twists& mechanism) const;

  const scene::Scene& scene_;
  std::vector<Point> centroids_;
  mutable std::vector<Face> faces_;  ///< friction that bends gets the tangents that loads so far have asked for
  std::vector<Tie> ties_;
  bool is_exact_ = false;
  double size_m_ = 0;          ///< by which lengths are scaled
  double weight_n_per_m_ = 0;  ///< by which forces are
};

}  // namespace blockweir::solid::limit
