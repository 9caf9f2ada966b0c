// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/capacity/static_strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <stdexcept>

#include "solid/capacity/released_blocks.hpp"
#include "solid/capacity/static_blocks.hpp"

namespace blockweir::solid {

scene::Scene with_reduced_strength(scene::Scene scene, double reduction) {
  scene.default_joint.reduce(reduction);
  for (scene::Joint& joint : scene.joints) joint.law.reduce(reduction);
  return scene;
}

namespace {

class Search {
 public:
  Search(const scene::Scene& scene, StillWater* water, double level_m, double guess, std::optional<double> jumps_below)
      : scene_(scene),
        water_(water),
        level_m_(level_m),
        jumps_below_(jumps_below),
        stands_at_(guess),
        fails_at_(guess) {
    if (jumps_below) effort_.knows(fmt::format("limit analysis: at most {:.6g}", guess));
  }

  StaticStrength found() {
    if (const auto bearing = bracket(); bearing != limit::Bearing::fails_at_a_factor) {
      return {.bearing = bearing, .moving = moving_};
    }
    StaticStrength found{.bearing = limit::Bearing::fails_at_a_factor};
    try {
      narrow();
      found.factor = (stands_at_ + fails_at_) / 2;
    } catch (const TookTooLong& stopped) {
      found.factor = stands_at_;
      found.stopped = stopped.what();
    }
    found.width = fails_at_ - stands_at_;
    found.creeps = creeps_;
    found.by_motion = by_motion_;
    return found;
  }

 private:
  bool stands(double reduction) {
    const scene::Scene reduced = with_reduced_strength(scene_, reduction);
    if (by_motion_) return comes_to_rest(reduced);
    try {
      StaticBlocks blocks(reduced, water_, effort_);
      const long most = most_systems(blocks.solid());
      const bool may_jump = jumps_below_ && reduction > *jumps_below_;
      effort_.allow(may_jump ? std::min(of_bound, most) : jumps_below_ ? most : LONG_MAX);
      if (blocks.begin(level_m_)) return true;
      moving_ = moving_most(blocks.solid());
      return false;
    } catch (const Undecided&) {
      creeps_ = true;
      // Near the bound what has found no rest by then counts as failing: the factor is at most 1 % too low by that.
      if (reduction > *jumps_below_) return false;
    } catch (const SolveError& error) {
      not_solved_ = error.what();  // it has no equilibrium under its first loads, or these cannot be solved
      if (!jumps_below_) return false;
    }
    by_motion_ = true;
    return comes_to_rest(reduced);
  }

  bool comes_to_rest(const scene::Scene& reduced) {
    effort_.allow(LONG_MAX);
    try {
      ReleasedBlocks blocks(reduced, water_, effort_);
      if (blocks.come_to_rest(level_m_)) return true;
      moving_ = moving_most(blocks.solid());
    } catch (const Undecided& why) {
      throw TookTooLong(fmt::format("{}; {}", why.what(), effort_.known()));
    } catch (const SolveError& error) {
      not_solved_ = error.what();
    }
    return false;
  }

  /// Grows from the guess on until it has both ends.
  limit::Bearing bracket() {
    constexpr double largest = 1e6;  // a factor beyond is none
    const bool first = stands(stands_at_);
    if (with_reduced_strength(scene_, 2) == scene_) return first ? limit::Bearing::bears_any : none();
    for (double step = nearest;; step *= 100) {
      effort_.knows(fmt::format("{} with strength over {:.6g}", first ? "stands" : "fails", stands_at_));
      double& end = first ? fails_at_ : stands_at_;
      if (jumps_below_ && stands_at_ < *jumps_below_) step = std::max(step, of_motion);  // nothing is near
      if (by_motion_) step = std::clamp(step, of_motion, 3.0);  // far stronger joints wedge blocks for long
      end = first ? end * (1 + step) : end / (1 + step);
      if (creeps_) {
        end = std::min(end, *jumps_below_);
        step = std::max(step, 1e-4);
      }
      if (end > largest) return limit::Bearing::bears_any;
      if (end < 1 / largest) return none();
      if (stands(end) != first) return limit::Bearing::fails_at_a_factor;
      (first ? stands_at_ : fails_at_) = end;
    }
  }

  /// Whatever the strength, nothing has found a rest. With ample strength the first loads have one, unless they cannot
  /// be solved: that is no answer.
  [[nodiscard]] limit::Bearing none() const {
    if (not_solved_.empty()) return limit::Bearing::bears_none;
    throw std::runtime_error("the blocks' equilibrium is not solved with any strength: " + not_solved_);
  }

  void narrow() {
    const auto width = [&] {
      return by_motion_ ? of_motion : creeps_ || (jumps_below_ && fails_at_ < *jumps_below_) ? of_jumps : exact;
    };
    while (fails_at_ - stands_at_ > width() * stands_at_) {
      effort_.knows(fmt::format("stands with strength over {:.7g}, fails over {:.7g}", stands_at_, fails_at_));
      const bool as_stated = by_motion_ && stands_at_ < 1 && fails_at_ > 1;
      const double middle = as_stated ? 1 : (stands_at_ + fails_at_) / 2;
      (stands(middle) ? stands_at_ : fails_at_) = middle;
    }
  }

  static constexpr double nearest = 1e-8;   // first step from the guess, over it
  static constexpr double exact = 1e-7;     // width of the bracket at the end, over the factor
  static constexpr double of_jumps = 1e-4;  // the same where the factor itself jumps by per cents
  static constexpr double of_motion = 1e-2;
  static constexpr long of_bound = 2000;  // linear systems of an analysis near the bound

  const scene::Scene& scene_;
  StillWater* water_;
  double level_m_;
  std::optional<double> jumps_below_;
  bool creeps_ = false;     ///< some analysis was given up
  bool by_motion_ = false;  ///< static steps have found no answer below the bound: blocks are let go
  std::string moving_;      ///< the block that went farthest in the last analysis that found no rest
  std::string not_solved_;  ///< why, of the last that was not
  SearchBudget effort_{"factor by the blocks"};
  double stands_at_;
  double fails_at_;
};

}  // namespace

bool stands(const scene::Scene& scene, StillWater* water, double level_m) {
  SearchBudget effort("the blocks");
  try {
    StaticBlocks blocks(scene, water, effort);
    effort.allow(most_systems(blocks.solid()));
    return blocks.begin(level_m);
  } catch (const Undecided&) {
    effort.allow(LONG_MAX);
  }
  return ReleasedBlocks(scene, water, effort).come_to_rest(level_m);
}

StaticStrength static_strength(const scene::Scene& scene, StillWater* water, double level_m, double guess,
                               std::optional<double> jumps_below) {
  return Search(scene, water, level_m, guess, jumps_below).found();
}

}  // namespace blockweir::solid
