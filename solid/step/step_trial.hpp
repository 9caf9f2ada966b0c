// SPDX-License-Identifier: GPL-3.0-or-later
// The trial of a step: possible positions of the blocks, and constant terms of their equations.
#pragma once

#include <vector>

#include "solid/contact/trial.hpp"
#include "solid/step/state.hpp"
#include "solid/step/step_mode.hpp"

namespace blockweir::solid {

/// For each block, by its index in the model. Triangles use the unknowns of their nodes.
class StepTrial {
 public:
  StepTrial(const Model& model, const State& state);

  std::vector<bool> frozen;  ///< fixed, or waiting while others settle: no unknowns
  Newmark scheme;            ///< for which the matrices were made
  double dt = -1;            ///< the same [s]; negative: matrices must be made again
  double end_s = 0;          ///< of the step
  double moved_m = 0;        ///< largest displacement of any vertex, as solved

  std::vector<Matrix6> matrix;         ///< inertia and elasticity
  std::vector<Vector6> external;       ///< loads at the end of the step
  std::vector<Vector6> history;        ///< past terms of the inertia; for triangles, at their corners
  std::vector<Vector6> past_velocity;  ///< velocity at the end of the step for zero increment
  std::vector<Vector6> began_with;     ///< initial velocities, in the form of the state
  std::vector<double> for_motion;      ///< work of loads less energy of strain and springs [J per metre]

  std::vector<Vector6> increment;
  std::vector<Turn> turn;             ///< of the increments
  std::vector<Placement> placement;   ///< with the increment
  std::vector<Point> node_increment;  ///< of meshes [m]
  std::vector<Vector6> balance;       ///< all forces except inertia
  /// Initial forces of sweeps for each contact [N per metre]; empty: the present ones.
  std::vector<Eigen::Vector2d> first_force;
  std::vector<double> round_off;  ///< round-off error of the balance [N per metre]

  /// Finds sliding blocks: their strains are damped unless the material states a damping.
  void find_sliding_blocks();
  void set_matrices(double step_s, const Newmark& of_scheme);
  /// Predicts positions: blocks and nodes continue their motion, fixed blocks follow a moving base.
  void begin();
  /// Predicts a block's initial increment from its present motion.
  void predict(std::size_t b);
  /// Sets the increment of a block.
  void go_to(std::size_t b, const Vector6& moved);
  void follow_corners(std::size_t triangle);
  [[nodiscard]] Vector6 corner_increment(std::size_t triangle) const;

  [[nodiscard]] Trial at_start() const {
    return {model_.blocks, state_.placements,         still_, unturned_, state_.placements,
            past_velocity, scheme.velocity_factor(dt)};
  }
  [[nodiscard]] Trial now() const {
    return {model_.blocks, state_.placements, increment, turn, placement, past_velocity, scheme.velocity_factor(dt)};
  }
  /// Whether this block (-1: the ground) has unknowns.
  [[nodiscard]] bool moves(int block) const { return block >= 0 && !frozen[static_cast<std::size_t>(block)]; }
  /// Rate of the six unknowns at a placement, from the state's rates.
  [[nodiscard]] Vector6 rate(std::size_t b, const Placement& at_placement, const Vector6& of_state) const;
  /// A generalized force in the form of the state.
  [[nodiscard]] Vector6 at_corners(std::size_t b, const Vector6& force) const;
  [[nodiscard]] Matrix6 inertia(std::size_t b) const;
  [[nodiscard]] double retardation_s(std::size_t b) const { return model_.blocks[b].retardation.of(slides_[b]); }
  /// Twice the free fall from rest in the step: a measure of the integrator's error [m].
  [[nodiscard]] double fall_m() const { return model_.scene.analysis.gravity_m_per_s2 * dt * dt; }
  /// Of the blocks, at the start of the step.
  [[nodiscard]] double fastest_m_per_s() const { return fastest_m_per_s_; }
  /// Whether a block is faster than this fall.
  [[nodiscard]] bool falls() const { return fastest_m_per_s_ * dt > fall_m(); }
  /// Largest displacement of any vertex [m].
  [[nodiscard]] double largest_increment() const;
  /// Whether a block has moved or turned more than a step may.
  [[nodiscard]] bool goes_too_far() const;

 private:
  void predict_nodes();
  void carry_fixed_blocks();
  [[nodiscard]] double largest_turn() const;

  const Model& model_;
  const State& state_;
  std::vector<bool> slides_;    ///< has a slipping contact at the start of the step
  std::vector<Vector6> still_;  ///< zero increments
  std::vector<Turn> unturned_;  ///< theirs
  double fastest_m_per_s_ = 0;
};

}  // namespace blockweir::solid
