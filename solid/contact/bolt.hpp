// SPDX-License-Identifier: GPL-3.0-or-later
// A bar between two blocks, or between a block and the ground: elastic, then plastic at a constant force; slack where
// it does not take compression.
#pragma once

#include "solid/block/moving_parts.hpp"
#include "solid/contact/force_rule.hpp"
#include "solid/contact/trial.hpp"

namespace blockweir::solid {

enum class BoltState { elastic, yielding, slack };

/// Tension and its slope at an elongation.
struct BoltForce {
  double tension_n_per_m = 0;
  double slope_n_per_m2 = 0;
  BoltState state = BoltState::elastic;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(tension_n_per_m, slope_n_per_m2, state);
  }
};

struct Bolt {
  const scene::Bolt* described = nullptr;
  std::array<int, 2> part{-1, -1};  ///< that the ends are in; -1: the ground
  std::array<Point, 2> material;    ///< m, ends relative to the centroids; of the ground: as the scene draws it
  double drawn_length_m = 0;

  // At the last accepted step.
  double elongation_m = 0;  ///< since the scene's drawing
  double plastic_m = 0;     ///< part of it that stays
  BoltForce acting{};

  template <class Archive>
  void serialize(Archive& archive) {
    archive(elongation_m, plastic_m, acting);
  }
};

Bolt make_bolt(const scene::Bolt& described, const MovingParts& parts);

/// prestress + stiffness (elongation - plastic elongation), cut off at yield, and at zero where compression is not
/// taken.
BoltForce bolt_force(const Bolt& bolt, double elongation_m);

/// The bolt's pull along the line between its ends at the trial; the second axis turns with the line.
Interaction interaction_of(const Trial& trial, const Bolt& bolt, const Point& ground_displacement);

/// For a solver of forces: a spring between its bounds, in compression.
Ruled ruled_bolt(const Trial& trial, const Bolt& bolt, const Point& ground_displacement);

/// Elongation, plastic elongation and force of an accepted step.
void accept(const Trial& trial, const Point& ground_displacement, Bolt& bolt);

}  // namespace blockweir::solid
