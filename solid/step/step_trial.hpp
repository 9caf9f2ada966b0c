// SPDX-License-Identifier: GPL-3.0-or-later
// What a step tries: where its blocks may go, and the terms of their equations that stand meanwhile.
#pragma once

#include <vector>

#include "solid/contact/trial.hpp"
#include "solid/step/state.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

/// Of each block, by its index in the model. Unknowns of triangles are their nodes'.
class StepTrial {
 public:
  StepTrial(const Model& model, const State& state);

  std::vector<bool> frozen;  ///< fixed, or waiting while others settle: no unknowns
  Newmark scheme;            ///< that matrices are made for
  double dt = -1;            ///< as well [s]; negative: they are to be made anew
  double end_s = 0;          ///< of the step

  std::vector<Matrix6> matrix;         ///< inertia and elasticity
  std::vector<Vector6> external;       ///< loads at the end of the step
  std::vector<Vector6> history;        ///< what inertia remembers; of triangles, at their corners
  std::vector<Vector6> past_velocity;  ///< what velocity would be at the end of the step without an increment
  std::vector<Vector6> began_with;     ///< velocities, as states have them
  std::vector<double> for_motion;      ///< what loads give less what strain and springs take up [J per metre]

  std::vector<Vector6> increment;
  std::vector<Placement> placement;   ///< with the increment
  std::vector<Point> node_increment;  ///< of meshes [m]
  std::vector<Vector6> balance;       ///< all forces but inertia
  /// That sweeps begin with, of each contact [N per metre]; empty: with those that act.
  std::vector<Eigen::Vector2d> first_force;
  std::vector<double> round_off;  ///< what is uncertain of the balance [N per metre]

  /// Which blocks slide: their strains are damped where the material does not say how.
  void find_sliding_blocks();
  void set_matrices(double step_s, const Newmark& of_scheme);
  /// Blocks and nodes go on as they move, fixed blocks where a moving base takes them.
  void begin();
  /// What a step begins with: the block goes on as it moves.
  void predict(std::size_t b);
  /// The block has moved so far in the step.
  void go_to(std::size_t b, const Vector6& moved);
  void follow_corners(std::size_t triangle);
  [[nodiscard]] Vector6 corner_increment(std::size_t triangle) const;

  [[nodiscard]] Trial at_start() const {
    return {model_.blocks, state_.placements, still_, state_.placements, past_velocity, scheme.velocity_factor(dt)};
  }
  [[nodiscard]] Trial now() const {
    return {model_.blocks, state_.placements, increment, placement, past_velocity, scheme.velocity_factor(dt)};
  }
  /// Has this block, -1 for the ground, unknowns?
  [[nodiscard]] bool moves(int block) const { return block >= 0 && !frozen[static_cast<std::size_t>(block)]; }
  /// Rate of the six unknowns at a placement, from the state's.
  [[nodiscard]] Vector6 rate(std::size_t b, const Placement& at_placement, const Vector6& of_state) const;
  /// A generalized force as the state has it.
  [[nodiscard]] Vector6 at_corners(std::size_t b, const Vector6& force) const;
  [[nodiscard]] Matrix6 inertia(std::size_t b) const;
  [[nodiscard]] double retardation_s(std::size_t b) const { return model_.blocks[b].retardation.of(slides_[b]); }
  /// Twice that of a fall from rest through the step: a measure of what the integrator is off by [m].
  [[nodiscard]] double fall_m() const { return model_.scene.analysis.gravity_m_per_s2 * dt * dt; }
  /// Is any block faster than that as the step begins?
  [[nodiscard]] bool falls() const { return falls_; }
  /// Largest displacement of any vertex [m].
  [[nodiscard]] double largest_increment() const;
  /// Do blocks move, one of them so far, or turn by more than a step may?
  [[nodiscard]] bool goes_too_far(double moved_m) const;

 private:
  void predict_nodes();
  void carry_fixed_blocks();
  [[nodiscard]] double largest_turn() const;

  const Model& model_;
  const State& state_;
  std::vector<bool> slides_;    ///< has a contact that slips as the step begins
  std::vector<Vector6> still_;  ///< no increment
  bool falls_ = false;
};

}  // namespace blockweir::solid
