// SPDX-License-Identifier: GPL-3.0-or-later
// Limit analysis of rigid blocks by linear programming. Static theorem: the largest factor on the live loads for which
// forces at the two ends of each face balance every block,
//   sum of forces and moments = 0,  N_i >= -T L/2,  |S| <= (c L + (N_1 + N_2) tan(phi))/reduction.
// Kinematic theorem, its dual: the mechanism for which (resistance - power of dead loads)/(power of live loads) equals
// this factor. Flow is associated: a slip opens the joint by tan(phi)/reduction times the slip. With Coulomb's friction
// the factor is therefore an upper bound.
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
  Twists mechanism;  ///< of the structure at its limit, scaled so that its fastest vertex has velocity 1
  double gap = 0;    ///< relative difference between the mechanism's own factor and that of the forces
};

/// Lack of strength: the least shear strength that must be added to every face, as a force over the structure's
/// weight.
struct Shortage {
  double ratio = 0;
  double per_reduction = 0;  ///< derivative with respect to the reduction
  Twists mechanism;          ///< as above; zero if nothing is lacking
  /// N/m m/s: what the limit of all normal forces together adds to the mechanism's resistance. Not zero: blocks jam,
  /// and forces that grow without limit would bear the loads.
  double jam_power = 0;
};

/// Corners in a kink of another block: they carry any force at a point (hold), or are crushed and carry none.
enum class Kinks { hold, give_way };

class LimitAnalysis {
 public:
  /// Throws std::invalid_argument if no block can move. The scene must outlive the object.
  explicit LimitAnalysis(const scene::Scene& scene, Kinks kinks = Kinks::hold);

  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  [[nodiscard]] const std::vector<Point>& centroids() const { return centroids_; }

  /// Otherwise factors and levels are upper bounds, with Coulomb's friction.
  [[nodiscard]] bool is_exact() const { return is_exact_; }
  /// Whether there are bolts without a yield strength, which carry any force.
  [[nodiscard]] bool holds_any_force() const;
  /// Whether some face has friction or cohesion.
  [[nodiscard]] bool has_shear_strength() const;

  /// The largest factor >= 0 on `live`, with `dead` unchanged.
  [[nodiscard]] LargestFactor largest_factor(const Wrenches& dead, const Wrenches& live) const;
  [[nodiscard]] bool bears(const Wrenches& loads) const;
  /// None if no shear strength is enough, as for overturning.
  [[nodiscard]] std::optional<Shortage> shortage(const Wrenches& loads, double reduction) const;

  /// The first motion of a structure that cannot carry its loads, with its shear strength or, if `however_strong`, with
  /// any shear strength: the mechanism with the most power over the sum of its velocities.
  [[nodiscard]] Twists collapse(const Wrenches& loads, bool however_strong) const;

  /// Smallest power that faces and bolts dissipate in a mechanism with associated flow.
  [[nodiscard]] double resistance(const Twists& mechanism, double reduction = 1) const;
  /// Velocity of face.b relative to face.a at a point.
  [[nodiscard]] Point jump(const Face& face, const Twists& mechanism, const Point& place) const;

 private:
  class Program;
  [[nodiscard]] Point velocity(int block, const Twists& mechanism, const Point& place) const;
  /// Returns by how much it was too fast.
  double normalize(Twists& mechanism) const;

  const scene::Scene& scene_;
  std::vector<Point> centroids_;
  mutable std::vector<Face> faces_;  ///< curved friction laws collect tangents as loads require them
  std::vector<Tie> ties_;
  bool is_exact_ = false;
  double size_m_ = 0;          ///< scale of lengths
  double weight_n_per_m_ = 0;  ///< scale of forces
};

}  // namespace blockweir::solid::limit
