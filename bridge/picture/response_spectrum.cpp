// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/picture/response_spectrum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace blockweir::picture {
namespace {

/// Displacement and velocity after a time of the free oscillator, by those before: rows of a matrix.
Eigen::Matrix2d free_motion(double omega, double zeta, double time_s) {
  const double damped = omega * std::sqrt(1 - zeta * zeta);
  const double decay = std::exp(-zeta * omega * time_s);
  const double c = decay * std::cos(damped * time_s);
  const double s = decay * std::sin(damped * time_s) / damped;
  Eigen::Matrix2d free;
  free << c + zeta * omega * s, s, -omega * omega * s, c - zeta * omega * s;
  return free;
}

}  // namespace

double pseudo_acceleration(const scene::TimeTable& a, double duration_s, double period_s, double damping_ratio) {
  const double omega = 2 * std::numbers::pi / period_s;
  const double step = std::min(period_s / 50, 0.005);
  const Eigen::Matrix2d free = free_motion(omega, damping_ratio, step);
  const double end_s = duration_s + period_s;
  Eigen::Vector2d now = Eigen::Vector2d::Zero();
  double largest = 0;
  double load = -a.at(0.0);
  for (double t = 0; t < end_s; t += step) {
    const double next_load = t + step <= duration_s ? -a.at(t + step) : 0;
    const double slope = (next_load - load) / step;
    // The motion under a load that grows evenly, without the free oscillation.
    const auto forced = [&](double of_load) {
      const double rate = slope / (omega * omega);
      return Eigen::Vector2d(of_load / (omega * omega) - 2 * damping_ratio / omega * rate, rate);
    };
    now = free * (now - forced(load)) + forced(next_load);
    load = next_load;
    largest = std::max(largest, std::abs(now[0]));
  }
  return omega * omega * largest;
}

}  // namespace blockweir::picture
