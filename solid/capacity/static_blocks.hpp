// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of a scene, at rest or not: static analyses one after the other under still water that follows them.
#pragma once

#include <limits>
#include <string>

#include "solid/capacity/search_budget.hpp"
#include "solid/capacity/still_water.hpp"
#include "solid/step/solid.hpp"
#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid {

class StaticBlocks {
 public:
  /// `water`: null where there is none. All must outlive it. What follows throws TookTooLong when the search's time is
  /// over; then the blocks are of no more use.
  StaticBlocks(const scene::Scene& scene, StillWater* water, SearchBudget& effort);

  /// From the scene's outline: lets weight and loads settle. Throws SolveError where they find no equilibrium at all.
  bool begin(double level_m);
  /// Goes on from where the blocks are; pressures follow them until they move no more. What goes farther than this
  /// share of the scene's failure_displacement_m does not rest, and neither does what slips so far before it rests, nor
  /// what has slipped by more than all of it since the scene's outline, beyond what weight and first loads strain.
  bool rests_at(double level_m, double share);

  /// Has anything gone as far as a failure since rests_at() was asked last?
  [[nodiscard]] bool went_far() const;
  /// Has anything slipped by more than a failure since the scene's outline, as rests_at() has it?
  [[nodiscard]] bool slipped_away() const;

  /// The name of the block whose centroid is farthest from where it is drawn.
  [[nodiscard]] std::string moving_most() const;

  /// Of a StaticBlocks of the same scene.
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

  [[nodiscard]] const Solid& solid() const { return solid_; }
  /// On the blocks where they are; nothing without water.
  const wire::Load& pressures(double level_m);
  Levels levels(double level_m);

 private:
  scene::Scene scene_;  ///< as its analyses are made
  double far_m_;        ///< its own failure displacement
  Solid solid_;
  double most_slip_m_ = std::numeric_limits<double>::infinity();
  StillWater* water_;
  wire::Motion motion_;
  double slipped_before_m_ = 0;  ///< as rests_at() began
  double moved_before_m_ = 0;
};

}  // namespace blockweir::solid
