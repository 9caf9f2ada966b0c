// SPDX-License-Identifier: GPL-3.0-or-later
// A stretch of a joint whose aperture w is linear, and the water that flows through it by the cubic law,
//   q = -w^3/(12 mu) d(p + rho g y)/ds,
// in closed form. Flow is per metre of thickness [m2/s].
#pragma once

#include <array>
#include <limits>

#include "fluid/joints/uplift.hpp"

namespace blockweir::joints {

/// Between two nodes of a network. Apertures are those at pressure 0; water of pressure p widens both by p/K_n.
struct Channel {
  int from = 0;
  int to = 0;
  double length_m = 0;
  std::array<double, 2> aperture_m{};
  double compliance_m_per_pa = 0;  ///< 1/K_n
  double least_m = 0;
  double largest_m = std::numeric_limits<double>::infinity();

  /// At one of its ends (0: from), with water of this pressure there.
  [[nodiscard]] double aperture(int end, double pressure_pa) const;
};

/// Flow over the fall in p + rho g y [m2/(Pa s)]: 1/(12 mu) over the integral of ds/w^3, and its slopes with the
/// apertures. Zero where an end is closed.
struct Conductance {
  double value = 0;
  std::array<double, 2> slope{};
};
Conductance conductance(double length_m, const std::array<double, 2>& aperture_m, double viscosity_pa_s);

/// Share 0..1 of the fall in p + rho g y that is left at a share t of the length: the curve between the ends.
double fall_left(const std::array<double, 2>& aperture_m, double t);

/// Pressure along a channel [m from its first node] that flows full from `from` to `to`: straight pieces with the force
/// and the moment of the curve that the closed form has.
Profile flowing(double length_m, const std::array<double, 2>& aperture_m, const End& from, const End& to,
                double water_n_per_m3);

/// The same where no flow fills it: water that stands as high as the pressures of its ends carry it.
Profile standing(double length_m, const End& from, const End& to, double water_n_per_m3);

}  // namespace blockweir::joints
