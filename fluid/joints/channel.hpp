// SPDX-License-Identifier: GPL-3.0-or-later
// A part of a joint with linear aperture w, and its flow by the cubic law,
//   q = -w^3/(12 mu) d(p + rho g y)/ds,
// in closed form. Flow is per metre of thickness [m2/s].
#pragma once

#include <array>
#include <limits>

#include "fluid/joints/uplift.hpp"

namespace blockweir::joints {

/// Connects two nodes of a network. Apertures are those at pressure 0; a water pressure p widens both by p/K_n.
struct Channel {
  int from = 0;
  int to = 0;
  double length_m = 0;
  std::array<double, 2> aperture_m{};
  double compliance_m_per_pa = 0;  ///< 1/K_n
  double least_m = 0;
  double largest_m = std::numeric_limits<double>::infinity();

  /// Aperture at an end (0: from) with this water pressure there.
  [[nodiscard]] double aperture(int end, double pressure_pa) const;
  /// By which it grows per pressure there [m/Pa]: zero at the bounds.
  [[nodiscard]] double widening(int end, double pressure_pa) const;
};

/// Flow over the drop in p + rho g y [m2/(Pa s)]: 1/(12 mu) over the integral of ds/w^3, and its derivatives with the
/// apertures. Zero if an end is closed.
struct Conductance {
  double value = 0;
  std::array<double, 2> slope{};
};
Conductance conductance(double length_m, const std::array<double, 2>& aperture_m, double viscosity_pa_s);

/// Share 0..1 of the drop in p + rho g y that remains at a share t of the length.
double fall_left(const std::array<double, 2>& aperture_m, double t);

/// Pressure along a full channel [m from its first node] between the pressures at its ends: linear pieces with the
/// force and moment of the exact curve.
Profile flowing(double length_m, const std::array<double, 2>& aperture_m, const End& from, const End& to,
                double water_n_per_m3);

/// The same without flow: water that stands as high as the pressures at its ends carry it.
Profile standing(double length_m, const End& from, const End& to, double water_n_per_m3);

}  // namespace blockweir::joints
