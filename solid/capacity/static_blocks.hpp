// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of a scene in a sequence of static analyses, under still water that follows the blocks.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "solid/capacity/search_budget.hpp"
#include "solid/capacity/still_water.hpp"
#include "solid/step/solid.hpp"
#include "solid/watch/failure_watch.hpp"

namespace blockweir::solid {

/// The name of the block that has moved most from where it was drawn, by its mass times the way of its centroid: a
/// crumb that has gone farther says nothing of the structure.
std::string moving_most(const Solid& solid);

/// Whether a support stands elsewhere at the run's end than the scene draws it.
bool supports_move(const Solid& solid);

/// Linear systems of one analysis that gets anywhere. Others creep, for minutes in a large scene.
long most_systems(const Solid& solid);

class StaticBlocks {
 public:
  /// `water` is null if there is none. The arguments must outlive the object. Its functions throw TookTooLong when the
  /// search's time is over; the object must not be used after that.
  StaticBlocks(const scene::Scene& scene, StillWater* water, SearchBudget& effort);

  /// Starts from the scene as drawn: weight and loads settle. Throws SolveError if there is no equilibrium at all.
  bool begin(double level_m);
  /// Continues from the present positions, with pressures that follow the blocks, until nothing moves. False if a
  /// displacement or a slip exceeds `share` of the scene's failure_displacement_m, or if a slip since the scene as
  /// drawn exceeds all of it (beyond that under weight and first loads).
  bool rests_at(double level_m, double share);

  /// Is it proved that they cannot rest where they are?
  bool must_move(double level_m);

  /// Whether anything has moved as far as a failure in the last rests_at().
  [[nodiscard]] bool went_far() const;
  /// Whether anything has slipped by more than a failure since the scene as drawn, measured as in rests_at().
  [[nodiscard]] bool slipped_away() const;

  /// State, to restore a StaticBlocks of the same scene.
  [[nodiscard]] std::string state() const;
  void restore(const std::string& state);

  [[nodiscard]] const Solid& solid() const { return solid_; }
  /// Pressures on the blocks at their present positions; empty without water.
  const wire::Load& pressures(double level_m);
  Levels levels(double level_m);
  /// About what holds them under that level, at which they rest.
  [[nodiscard]] std::vector<std::string> warnings(double level_m);

 private:
  scene::Scene scene_;  ///< modified for these analyses
  double far_m_;        ///< the scene's failure displacement
  Solid solid_;
  double most_slip_m_ = std::numeric_limits<double>::infinity();
  StillWater* water_;
  wire::Motion motion_;
  double slipped_before_m_ = 0;  ///< at the start of rests_at()
  double moved_before_m_ = 0;
};

}  // namespace blockweir::solid
