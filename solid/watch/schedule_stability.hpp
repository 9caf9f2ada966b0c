// SPDX-License-Identifier: GPL-3.0-or-later
// Does an explicit schedule grow? Theory: a block on a spring against water that is inertia and stiffness.
#pragma once

#include <string>

#include "bridge/scene/scene.hpp"

namespace blockweir::solid {

/// m x'' + k x = -p, p = m_a x'' + c x; p by backward differences of the velocities told, one window late and more.
struct Oscillator {
  double mass = 0;
  double stiffness = 0;
  double added_mass = 0;
  double added_stiffness = 0;
  double guarded_mass = 0;  ///< that the guard knows of
  double window_s = 0;
  scene::Integrator integrator = scene::Integrator::shi;
  scene::Schedule schedule = scene::Schedule::serial;
  scene::LoadInWindow load = scene::LoadInWindow::held;
};

/// Of a column without a cushion against the block. Throws std::runtime_error where the scene has no such thing, or
/// the steps are not the windows.
Oscillator oscillator_of(const scene::Scene& scene, const std::string& block);

/// By what displacements grow a window: the spectral radius of the window's map. 1 and less is stable.
double schedule_growth(const Oscillator& o);

/// Added mass over mass, up to 1, that the scene's schedule is stable with by itself, whatever the step.
double largest_stable_ratio(const scene::Scene& scene);

/// What grows by less is not seen by InterfaceEnergy, which asks for a fourfold energy in 40 windows.
constexpr double least_growth = 1.0175;

}  // namespace blockweir::solid
