// SPDX-License-Identifier: GPL-3.0-or-later
// Which law holds between which two blocks, and on which edge.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/contact/joint_law.hpp"

namespace blockweir::solid {

/// A joint law with angles as tangents.
struct JointProperties {
  double friction = 0;
  double residual_friction = 0;
  double cohesion_pa = 0;
  double tension_pa = 0;
  double bonded_length_m = -1;  ///< of the whole joint; negative: all of it
  bool keeps_cohesion = false;
  double softening_slip_m = 0;  ///< path of slip over which a bond fades; 0: it is brittle
  double dilation = 0;          ///< opening per slip
  double dilation_limit_m = std::numeric_limits<double>::infinity();  ///< slip beyond which it opens no further
  int joint = -1;                                                     ///< index into Scene::joints, -1 for the default

  /// Has it a bond that can be lost? Whether it is depends on the states on the way to an equilibrium.
  [[nodiscard]] bool bonds() const { return cohesion_pa > 0 || tension_pa > 0 || friction != residual_friction; }
  /// Of a contact whose bond of that length is left to the part `bond`.
  [[nodiscard]] Strength strength(double bond, double length) const {
    return {.friction = residual_friction + bond * (friction - residual_friction),
            .cohesion = bond * cohesion_pa * length,
            .tension = bond * tension_pa * length};
  }
  /// What is left of a softening bond after so long a path of slip.
  [[nodiscard]] double bond_after(double slip_path_m) const {
    if (keeps_cohesion || softening_slip_m == 0) return 1;
    return std::max(0.0, 1 - slip_path_m / softening_slip_m);
  }
  /// Gap that a joint has when its faces ride on each other's roughness after so much slip: a saw tooth of this law's
  /// slope.
  [[nodiscard]] double dilation_m(double slip_m) const {
    return dilation * std::min(std::abs(slip_m), dilation_limit_m);
  }
  /// -d dilation_m / d slip; at zero slip in the given direction.
  [[nodiscard]] double dilation_slope(double slip_m, double direction) const {
    if (std::abs(slip_m) >= dilation_limit_m) return 0;
    return -dilation * std::copysign(1.0, slip_m != 0 ? slip_m : direction);
  }
};

class JointLaws {
 public:
  explicit JointLaws(const scene::Scene& scene);

  /// Of two blocks as the scene has them; 0 where it states none.
  [[nodiscard]] int between(int block_a, int block_b) const {
    const auto found = by_pair_.find(key(block_a, block_b));
    return found == by_pair_.end() ? 0 : found->second;
  }
  /// An edge of a block in the scene, of which a part lies on a plane (0: on none).
  struct Edge {
    int block = 0;
    int edge = 0;
    int plane = 0;
  };
  /// Of a vertex of a block on another's edge; the face that ends at the vertex lies on `face_plane`. Blocks that meet
  /// on their way have the edge's plane, else the face's. The law of a pair that the scene states yields to a plane
  /// that both lie on and that is not the pair's own: each plane holds on its line.
  [[nodiscard]] int of_contact(int vertex_block, int face_plane, const Edge& on) const;
  /// The joints that lie along one plane have a law in common for what slides onto it later, without their bonds. That
  /// of the plane that most of a part of a block's edge lies on, fractions as in scene::TracePiece; 0 where half of it
  /// or more lies on none.
  [[nodiscard]] int plane_of(int block, int edge, double s_from, double s_to) const;
  [[nodiscard]] bool any_plane() const { return !on_planes_.empty(); }
  [[nodiscard]] bool dilate() const {
    return std::any_of(laws_.begin(), laws_.end(), [](const JointProperties& law) { return law.dilation > 0; });
  }
  [[nodiscard]] const JointProperties& operator[](int law) const { return laws_[static_cast<std::size_t>(law)]; }

 private:
  static std::uint64_t key(int a, int b) {
    const auto low = static_cast<std::uint64_t>(a < b ? a : b);
    const auto high = static_cast<std::uint64_t>(a < b ? b : a);
    return low << 32U | high;
  }
  /// A part of a block's edge.
  struct OnPlane {
    int edge = 0;
    double s_from = 0;
    double s_to = 0;
    int plane = 0;
    int joint_law = 0;  ///< of the joint that lies here
  };
  void add_planes(const scene::Scene& scene);
  [[nodiscard]] int add_plane(int own);
  void add_neighbours_of_planes(const scene::Scene& scene, double touching_m);

  std::vector<JointProperties> laws_;
  std::vector<int> planes_;                                  ///< law of the plane that a law's joint lies on, 0: none
  std::unordered_map<std::uint64_t, int> by_pair_;           ///< stated; 0 where blocks touch beside a plane
  std::unordered_map<int, std::vector<OnPlane>> on_planes_;  ///< by block
};

}  // namespace blockweir::solid
