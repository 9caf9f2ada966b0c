// SPDX-License-Identifier: GPL-3.0-or-later
// A block that stands on the ground, and a step of it that has begun.
#pragma once

#include "solid/step/step_islands.hpp"
#include "solid/step/time_step.hpp"

namespace blockweir::solid {

/// A fixed ground, block 0, and on it `blocks` rigid stones of 1 m x 1 m, 25 kN each at 10 m/s2, on joints of 30
/// degrees.
inline scene::Scene stones(int blocks = 1) {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  scene.analysis.gravity_m_per_s2 = 10;
  scene.analysis.step_s = 0.01;
  scene.analysis.rigid = scene::Rigid::all;
  scene.blocks.push_back({.name = "ground", .vertices = {{-5, -1}, {15, -1}, {15, 0}, {-5, 0}}, .fixed = true});
  for (int k = 0; k < blocks; ++k) {
    const double x = 2.0 * k;
    scene.blocks.push_back(
        {.name = "stone " + std::to_string(k), .vertices = {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}});
  }
  return scene;
}

struct Sample {
  explicit Sample(const scene::Scene& of) : scene(of), model(scene), state(model), step(model, state), water(step) {}

  const scene::Scene scene;
  Model model;
  State state;
  StepWorkspace step;
  WaterInertia water;
  StepIslands islands{step, water};
  const StepMode mode{.scheme = {}};

  /// As a step of `dt` seconds begins, under weight alone.
  void begin(double dt = 0.01) {
    islands.prepare();
    step.trial.end_s = dt;
    step.trial.find_sliding_blocks();
    step.trial.set_matrices(dt, mode.scheme);
    model.loads.evaluate(dt, {}, state.placements, step.trial.external);
    step.trial.begin();
    for (IslandEquations& s : islands) {
      step.formulation->begin(step.trial.at_start(), step.trial.matrix, step.trial.frozen, s.island_contacts());
    }
  }
  IslandEquations& island() { return *islands.begin(); }
};

/// Upward forces of the contacts of a block with the ground [N per metre].
inline double reaction(const State& state, int block) {
  double sum = 0;
  for (const ContactPoint& c : state.contacts) {
    if (c.state != ContactState::open && (c.vertex_block == block || c.edge_block == block)) sum += c.force.x();
  }
  return sum;
}

}  // namespace blockweir::solid
