// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/channel.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::joints {
namespace {

/// Of the share of the fall that is left at t = s/L, integral of t times it over t: with w = w_1 (1 + k t),
///   share left = ((1 + k t)^-2 - (1 + k)^-2)/(1 - (1 + k)^-2).
double first_moment(double k) {
  // int t (1 + k t)^-2 dt = (ln(1 + k) + 1/(1 + k) - 1)/k^2, as a series where that cancels.
  constexpr double small = 0.02;
  double integral = 0;
  if (std::abs(k) > small) {
    integral = (std::log1p(k) + 1 / (1 + k) - 1) / (k * k);
    const double last = 1 / ((1 + k) * (1 + k));
    return (integral - last / 2) / (1 - last);
  }
  // t (1 + k t)^-2 = sum (n + 1) (-k)^n t^(n + 1); less (1 + k)^-2 t, over k (2 + k)/(1 + k)^2.
  double term = 1;
  double sum = 0;
  for (int n = 1; n <= 12; ++n) {
    term *= -k;
    sum += (n + 1) * term / k * (1.0 / (n + 2) - 0.5);
  }
  return k == 0 ? 1.0 / 6 : sum * (1 + k) * (1 + k) / (2 + k);
}

}  // namespace

double Channel::aperture(int end, double pressure_pa) const {
  const double wide = aperture_m[static_cast<std::size_t>(end)] + compliance_m_per_pa * pressure_pa;
  return std::clamp(wide, least_m, largest_m);
}

double Channel::widening(int end, double pressure_pa) const {
  const double wide = aperture_m[static_cast<std::size_t>(end)] + compliance_m_per_pa * pressure_pa;
  return wide > least_m && wide < largest_m ? compliance_m_per_pa : 0;
}

Conductance conductance(double length_m, const std::array<double, 2>& aperture_m, double viscosity_pa_s) {
  const auto [a, b] = aperture_m;
  if (a <= 0 || b <= 0) return {};
  // 12 times the integral of ds/w^3 is 6 L (a + b)/(a b)^2.
  const double value = a * a * b * b / (6 * viscosity_pa_s * length_m * (a + b));
  return {value, {value * (2 / a - 1 / (a + b)), value * (2 / b - 1 / (a + b))}};
}

double fall_left(const std::array<double, 2>& aperture_m, double t) {
  // (w^-2 - b^-2)/(a^-2 - b^-2), without differences of what is nearly equal: w - b = (1 - t)(a - b).
  const auto [a, b] = aperture_m;
  const double w = a + t * (b - a);
  return w > 0 && a + b > 0 ? (1 - t) * (w + b) * a * a / ((a + b) * w * w) : 1 - t;
}

Profile flowing(double length_m, const std::array<double, 2>& aperture_m, const End& from, const End& to,
                double water_n_per_m3) {
  Profile profile;
  profile.add(0, from.pressure_pa);
  const auto [a, b] = aperture_m;
  const double fall = from.pressure_pa - to.pressure_pa + water_n_per_m3 * (from.height_m - to.height_m);
  // The mean of the share that is left is a/(a + b), that of a straight line 1/2.
  const double beyond_straight = fall * (a / (a + b) - 0.5);
  const double moment_beyond = fall * (first_moment(b / a - 1) - 1.0 / 6);
  const double scale = std::max({std::abs(fall), from.pressure_pa, to.pressure_pa});
  if (a > 0 && b > 0 && std::abs(beyond_straight) > 1e-14 * scale) {
    // A line with one kink at t L, d off the straight one, has d/2 more area and d (1 + t)/6 more moment.
    const double off = 2 * beyond_straight;
    const double at = 6 * moment_beyond / off - 1;
    const double straight = from.pressure_pa + at * (to.pressure_pa - from.pressure_pa);
    if (at > 0 && at < 1) profile.add(at * length_m, std::max(0.0, straight + off));
  }
  profile.add(length_m, to.pressure_pa);
  return profile;
}

Profile standing(double length_m, const End& from, const End& to, double water_n_per_m3) {
  const bool from_first =
      from.pressure_pa + water_n_per_m3 * from.height_m > to.pressure_pa + water_n_per_m3 * to.height_m;
  // The lower end's water reaches up; the higher end is wet only where that water reaches it.
  const End& low = from.height_m == to.height_m ? (from_first ? from : to) : from.height_m < to.height_m ? from : to;
  const auto pressure = [&](double height_m) {
    return std::max(0.0, low.pressure_pa - water_n_per_m3 * (height_m - low.height_m));
  };
  Profile profile;
  profile.add(0, pressure(from.height_m));
  const double rise = to.height_m - from.height_m;
  if (rise != 0) {
    const double surface_m = low.height_m + low.pressure_pa / water_n_per_m3;
    const double share = (surface_m - from.height_m) / rise;
    if (share > 0 && share < 1) profile.add(share * length_m, 0);
  }
  profile.add(length_m, pressure(to.height_m));
  return profile;
}

}  // namespace blockweir::joints
