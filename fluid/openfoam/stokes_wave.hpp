// SPDX-License-Identifier: GPL-3.0-or-later
// A regular wave of Stokes's second order above a level bed: omega^2 = g k tanh(k d); elevation and horizontal velocity
// as functions of the phase, the height above the bed and the height H from trough to crest.
#pragma once

#include <cmath>

namespace blockweir::openfoam {

struct StokesWave {
  double height_m = 0;
  double period_s = 1;
  double depth_m = 1;  ///< of the still water
  double gravity_m_per_s2 = 9.81;

  [[nodiscard]] double frequency() const { return 2 * M_PI / period_s; }

  /// By Newton's method on x tanh(x) = omega^2 d/g, x = k d, started above the root, where it always converges.
  [[nodiscard]] double wave_number() const {
    const double deep = frequency() * frequency() * depth_m / gravity_m_per_s2;
    double x = deep > 1 ? deep * 1.2 : std::sqrt(deep) * 1.2;
    for (int i = 0; i < 50; ++i) {
      const double t = std::tanh(x);
      x -= (x * t - deep) / (t + x * (1 - t * t));
    }
    return x / depth_m;
  }
  [[nodiscard]] double length_m() const { return 2 * M_PI / wave_number(); }
  /// H L^2/d^3: second order is valid up to 26; beyond, the trough would show a secondary crest.
  [[nodiscard]] double ursell_number() const {
    return height_m * length_m() * length_m() / (depth_m * depth_m * depth_m);
  }
  /// Miche's limit: higher waves break.
  [[nodiscard]] double highest_m() const { return 0.142 * length_m() * std::tanh(wave_number() * depth_m); }

  [[nodiscard]] double elevation(double phase) const {
    const double k = wave_number();
    const double kd = k * depth_m;
    const double s = std::sinh(kd);
    const double second = k * height_m / 8 * std::cosh(kd) * (2 + std::cosh(2 * kd)) / (s * s * s);
    return height_m / 2 * (std::cos(phase) + second * std::cos(2 * phase));
  }
  /// Horizontal velocity under a crest of 1 m to first order [1/s].
  [[nodiscard]] double velocity_per_elevation(double above_bed_m) const {
    const double k = wave_number();
    return frequency() * std::cosh(k * above_bed_m) / std::sinh(k * depth_m);
  }
  [[nodiscard]] double velocity(double phase, double above_bed_m) const {
    const double k = wave_number();
    const double s = std::sinh(k * depth_m);
    const double second = 0.1875 * height_m * height_m * frequency() * k / (s * s * s * s);
    return height_m / 2 * velocity_per_elevation(above_bed_m) * std::cos(phase) +
           second * std::cosh(2 * k * above_bed_m) * std::cos(2 * phase);
  }
};

}  // namespace blockweir::openfoam
