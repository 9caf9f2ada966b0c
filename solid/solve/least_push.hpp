// SPDX-License-Identifier: GPL-3.0-or-later
// Of all displacements of rigid bodies that leave no overlap those that move least mass: 0 <= gap _|_ push >= 0.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

namespace blockweir::solid {

/// Where two bodies, or a body and what does not move, may overlap.
struct Overlap {
  struct End {
    int body = -1;                                    ///< -1: does not move
    Eigen::Vector3d opens = Eigen::Vector3d::Zero();  ///< d gap / d (x, y, turn)
  };
  double gap = 0;  ///< m
  std::array<End, 2> ends;
};

class LeastPush {
 public:
  /// `mass` of each body against (x, y, turn).
  LeastPush(std::vector<Eigen::Vector3d> mass, std::vector<Overlap> overlaps);

  /// Newton's method with a line search on a convex energy, overlaps being springs so stiff that next to nothing of
  /// them is left. Ends where none is deeper than that [m].
  void solve(double tolerance_m);

  [[nodiscard]] const Eigen::Vector3d& moved(std::size_t body) const { return moved_[body]; }
  /// Overlap that is left [m].
  [[nodiscard]] double deepest() const;

 private:
  [[nodiscard]] double gap(std::size_t overlap) const;
  using Displacements = std::vector<Eigen::Vector3d>;
  [[nodiscard]] double opened(const Overlap& o, const Displacements& by) const;
  [[nodiscard]] Displacements towards_equilibrium();
  [[nodiscard]] double fraction_of(const Displacements& way) const;

  std::vector<Eigen::Vector3d> mass_;
  std::vector<Overlap> overlaps_;
  std::vector<double> stiffness_;
  Displacements moved_;
  std::vector<int> place_;  ///< of a body's unknowns while they are solved for
};

}  // namespace blockweir::solid
