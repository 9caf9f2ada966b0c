// SPDX-License-Identifier: GPL-3.0-or-later
// Theoretical stability of an explicit schedule: a block on a spring against water with inertia and stiffness.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"

namespace blockweir::solid {

/// m x'' + k x = -p, p = m_a x'' + c x; p from backward differences of the exchanged velocities, with a delay.
struct Oscillator {
  double mass = 0;
  double stiffness = 0;
  double added_mass = 0;
  double added_stiffness = 0;
  double guarded_mass = 0;  ///< added mass that the guard takes into account
  double window_s = 0;
  scene::Integrator integrator = scene::Integrator::shi;
  scene::Schedule schedule = scene::Schedule::serial;
  scene::LoadInWindow load = scene::LoadInWindow::held;
};

/// For a column without a cushion against the block. Throws std::runtime_error if the scene has no such thing, or if
/// steps differ from windows.
Oscillator oscillator_of(const scene::Scene& scene, const std::string& block);

/// Growth of displacements in a window: the spectral radius of the window's map. Stable up to 1.
double schedule_growth(const Oscillator& o);

/// Largest ratio of added mass to mass, up to 1, at which the scene's schedule is stable without guard, for any step.
double largest_stable_ratio(const scene::Scene& scene);

/// Slower growth is not detected by InterfaceEnergy, which needs a fourfold energy in 40 windows.
constexpr double least_growth = 1.0175;

}  // namespace blockweir::solid
