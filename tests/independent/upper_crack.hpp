// SPDX-License-Identifier: GPL-3.0-or-later
// The block above the upper crack whose friction, cohesion and density are uncertain: its head of failure by limit
// equilibrium, and the distribution of that head by quadrature.
#pragma once

#include <array>
#include <string>

namespace blockweir::independent {

struct UncertainCrack {
  // Normal, mean and deviation; a deviation of 0: it is the mean. By these the block weighs what that of the paper
  // does.
  std::array<double, 2> friction_deg{30, 2};
  std::array<double, 2> cohesion_pa{0, 0};
  std::array<double, 2> density_kg_per_m3{1821.4731361036681, 0};

  /// Sliding on the dry crack: P (cos a + sin a tan phi) = W (cos a tan phi - sin a) + c L, P = rho_w g z^2/2.
  [[nodiscard]] double head_m(double phi_deg, double bond_pa, double density) const;

  /// Probability of a head below `head_m`: exact in friction, by Simpson's rule over the other two.
  [[nodiscard]] double below(double head_m) const;

  /// Sobol's first order and total indices of the head, in the order of the members, by Simpson's rule over all three.
  struct Indices {
    std::array<double, 3> first;
    std::array<double, 3> total;
  };
  [[nodiscard]] Indices indices() const;

  /// The scene, with a [[random]] for each member that has a deviation.
  [[nodiscard]] std::string scene() const;
};

}  // namespace blockweir::independent
