// SPDX-License-Identifier: GPL-3.0-or-later
// Which law holds between which two blocks, and on which edge.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "bridge/scene/scene.hpp"
#include "solid/contact/contact_point.hpp"

namespace blockweir::solid {

class JointLaws {
 public:
  explicit JointLaws(const scene::Scene& scene);

  /// Law of two blocks as drawn; 0 if the scene states none.
  [[nodiscard]] int between(int block_a, int block_b) const {
    const auto found = by_pair_.find(key(block_a, block_b));
    return found == by_pair_.end() ? 0 : found->second;
  }
  /// An edge of a block in the scene, of which a part lies on a plane (0: on none).
  struct Edge {
    int block = 0;
    int edge = 0;
    int plane = 0;
    bool in_line = false;  ///< with the vertex's face, as both were drawn
  };
  /// Law of a vertex of a block on another's edge; the face that ends at the vertex lies on `face_plane`. Blocks that
  /// come to touch have the law of a plane on which both were drawn, the edge's first: one that falls has left its
  /// plane. If both lie on a plane that is not the pair's own, its law replaces that of the pair: each plane's law
  /// holds along its line.
  [[nodiscard]] int of_contact(int vertex_block, int face_plane, const Edge& on) const;
  /// Joints along one plane have a common law for blocks that slide onto it later, without their bonds. Returns the
  /// plane with the largest share of a part of a block's edge (fractions as in scene::TracePiece); 0 if half of it or
  /// more lies on no plane.
  [[nodiscard]] int plane_of(int block, int edge, double s_from, double s_to) const;
  [[nodiscard]] bool any_plane() const { return !on_planes_.empty(); }
  [[nodiscard]] bool dilate() const {
    return std::any_of(laws_.begin(), laws_.end(), [](const JointProperties& law) { return law.dilates(); });
  }
  /// Of a contact near a normal force [N per metre].
  [[nodiscard]] Strength strength(const ContactPoint& c, double normal) const {
    return (*this)[c.law].strength(c.bond, c.bond_length, c.length, normal);
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
