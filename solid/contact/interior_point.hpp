// SPDX-License-Identifier: GPL-3.0-or-later
// Primal-dual interior point method for contacts with friction whose bounds lag (Wright 1997, Primal-Dual
// Interior-Point Methods; for friction Kucera, Machalova, Netuka and Zencak 2013, Optim. Methods Softw. 28): forces and
// the motions that they resist stay positive, while their products go to zero together. However many contacts change
// their state, some tens of solutions find all states.
#pragma once

#include <limits>

#include "solid/contact/complementary_pair.hpp"
#include "solid/contact/formulation.hpp"

namespace blockweir::solid {

class InteriorPoint final : public Formulation {
 public:
  /// Where forces that act are known to change by no more than about `change_n` [N per metre], they are what it begins
  /// with.
  InteriorPoint(const JointLaws& laws, const FormulationSettings& settings,
                double change_n = std::numeric_limits<double>::infinity())
      : Formulation(laws, settings), change_n_(change_n) {}

  /// Forces that act now, the largest of them, set the scale.
  void begin(const Trial& trial, const std::vector<Matrix6>& matrix, const std::vector<bool>& frozen,
             const IslandContacts& island) override;

  /// Newton's method on the products: the force is the one after a correction without displacement.
  Interaction contact(const Trial& trial, int index, ContactPoint& c) override;
  Interaction support(const Trial& trial, int index, Support& s) override;
  bool sweep(const IslandContacts& /*island*/) override { return true; }

  [[nodiscard]] double scale_n() const { return scale_n_; }  ///< [N per metre]

  /// Once the blocks have moved by a whole correction that aims at products of zero: what the next one, with the same
  /// matrix, is to aim at instead (Mehrotra 1992, SIAM J. Optim. 2).
  void predict(const Trial& trial, const IslandContacts& island);
  /// Call after a whole correction of the blocks: the fraction of it that leaves all variables positive, at least half,
  /// which the forces follow. The few pairs that half would make negative stop before, and the next correction removes
  /// their error: otherwise a brick that hardly anything holds sideways delays thousands of contacts.
  double follow_correction(const Trial& trial, const IslandContacts& island);
  /// Forces and states, for the augmented Lagrangian to begin with.
  void hand_over(const IslandContacts& island) const;

 private:
  using Pair = ComplementaryPair;
  struct Point {
    Pair normal;    ///< pressure above the tension that can be borne, gap
    Pair forward;   ///< bound + shear, slip along the edge
    Pair backward;  ///< bound - shear, slip the other way
    double shear = 0;
    double shear_change = 0;
    bool has_friction = false;
    Eigen::Vector2d separation = Eigen::Vector2d::Zero();  ///< where it was linearized
    Eigen::Vector2d force = Eigen::Vector2d::Zero();      ///< after a correction that moves nothing, less its stiffness
    Eigen::Vector2d stiffness = Eigen::Vector2d::Zero();  ///< times what does move
  };

  void begin_contact(const Trial& /*trial*/, const std::vector<bool>& /*frozen*/, int /*k*/,
                     ContactPoint& /*c*/) override {}
  void begin_support(const Trial& /*trial*/, int /*k*/, Support& /*s*/) override {}

  [[nodiscard]] double tension(const ContactPoint& c) const { return laws_.strength(c, c.force.x()).tension; }
  /// By the pressure of now.
  [[nodiscard]] double shear_bound(const ContactPoint& c, const Point& p) const;

  /// Its changes, with a change of its force.
  void follow(Pair& pair, double change) const;
  /// By a whole correction; returns the fraction of it that leaves all positive.
  double find_changes(const Trial& trial, const IslandContacts& island);
  /// After that fraction of the changes.
  [[nodiscard]] double mean_product(const IslandContacts& island, double fraction);

  template <class Work>
  void for_pairs(const IslandContacts& island, const Work& work) {
    for (const int k : island.contact_ids) {
      Point& p = points_[static_cast<std::size_t>(k)];
      work(p.normal);
      if (!p.has_friction) continue;
      work(p.forward);
      work(p.backward);
    }
  }

  std::vector<Point> points_;
  double change_n_;
  double scale_n_ = 0;
  double fraction_ = 1;  ///< of the last correction
  double product_ = 0;   ///< that the next correction aims at
};

}  // namespace blockweir::solid
