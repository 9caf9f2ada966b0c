// SPDX-License-Identifier: GPL-3.0-or-later
// Finds whether, at which level and how a structure fails: from its motion, not from a threshold on the load.
//
// A block is at rest while no vertex is faster than rest_speed_m_per_s. It also counts as at rest if its contacts allow
// no rigid motion (mobility.hpp) in several evaluations: then it only strains or oscillates. A motion that carries a
// vertex farther than failure_displacement_m without rest in between is a failure; a slip that ends in a new
// equilibrium is not. Failure begins, and the level is taken, when the block was last at rest. Blocks that nothing
// holds from the start, beside others that something does, are not judged. A crumb (bridge/scene/crumbs.hpp) is taken
// for the one that fails only while no other block moves.
#pragma once

#include "bridge/scene/joint_trace.hpp"
#include "solid/step/solid.hpp"
#include "solid/watch/slips_since_rest.hpp"

namespace blockweir::solid {

/// Levels of the pools [m]; NaN without a pool.
struct Levels {
  double upstream_m = std::numeric_limits<double>::quiet_NaN();
  double downstream_m = std::numeric_limits<double>::quiet_NaN();

  /// The downstream pool is higher: the structure is pushed upstream.
  [[nodiscard]] bool reversed() const { return !std::isnan(downstream_m) && !(upstream_m >= downstream_m); }
  [[nodiscard]] double of(bool downstream) const { return downstream ? downstream_m : upstream_m; }
  [[nodiscard]] double higher_m() const { return of(reversed()); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(upstream_m, downstream_m);
  }
};

/// Failure of blocks that move as one body.
struct Failure {
  std::vector<int> blocks;  ///< in the scene's order
  double time_s = 0;        ///< when it was last at rest
  double level_m = 0;       ///< of a pool at that time: changing_pool(); NaN without a pool, or below all moving blocks
  bool downstream = false;  ///< it is the downstream pool's level
  bool falls = false;       ///< the level was falling
  double head_m = 0;        ///< level above the end of the failed joint on its side; NaN without a pool
  /// It was never at rest, or nothing changes: the failure level is at most this, or at least if the level falls.
  bool bound = false;
  /// Uncertainty of level_m: rise of the level in a window, while the body was too slow to be detected, and while it
  /// stuck intermittently or inertia carried it (fast filling, oscillation). NaN as above, for a bound, and for a
  /// constant level.
  double level_uncertainty_m = 0;
  double window_rise_m = 0;  ///< the first part of it
  double travel_m = 0;       ///< when the failure was certain
  std::string mode;          ///< "sliding", "overturning", "sliding and overturning", "lifting" or "falling"
  std::string joint;         ///< on which the body moves; empty if it falls or flies freely
  std::string turns_on;      ///< the joint that bears while `joint` opens; empty if that bears

  template <class Archive>
  void serialize(Archive& archive) {
    archive(blocks, time_s, level_m, downstream, falls, head_m, bound, level_uncertainty_m, window_rise_m, travel_m,
            mode, joint, turns_on);
  }
};

/// A block that moves and has not failed yet.
struct Moving {
  int block = 0;
  double speed_m_per_s = 0;
  double travel_m = 0;  ///< since it was last at rest
};

class FailureWatch {
 public:
  explicit FailureWatch(const Solid& solid);

  /// Evaluates the state at `time_s`, reached under these levels.
  void look(double time_s, const Levels& levels);

  /// Whether every block was at rest, or strained slowly, at the last evaluation.
  [[nodiscard]] bool at_rest() const { return at_rest_; }

  /// Failures so far, the earliest first; those of crumbs alone come after the others.
  [[nodiscard]] const std::vector<Failure>& failures() const { return failures_; }

  /// Whether anything but crumbs has failed.
  [[nodiscard]] bool failed() const { return !failures_.empty() && !of_crumbs(failures_.front()); }

  /// Whether only crumbs fail.
  [[nodiscard]] bool of_crumbs(const Failure& failure) const;

  /// Blocks that are not judged, because they fall from the start.
  [[nodiscard]] const std::vector<int>& loose() const { return loose_; }

  /// Whether all blocks but those are fixed or led by supports.
  [[nodiscard]] bool judges_none() const;

  /// Whether all failed blocks were at rest at the last evaluation.
  [[nodiscard]] bool rests_again() const;

  /// Largest displacement of a failed block's vertex from the scene as drawn, relative to the base [m];
  /// of those that set out before this time.
  [[nodiscard]] double farthest_failed_m(double before_s = std::numeric_limits<double>::infinity()) const;

  /// The fastest block that neither is at rest nor has failed, a crumb only if no other is left; none if there is none.
  /// Blocks that no forces hold are not at rest, however slow they are: as they begin to move, what sweeps leave may
  /// exceed what little drives them.
  [[nodiscard]] std::optional<Moving> moving() const;
  [[nodiscard]] bool unheld() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(watched_, slow_, stands_, slipped_, slips_, at_rest_, begun_, seen_s_, failures_);
  }

 private:
  struct Watched {
    double time_s = 0;  ///< when the block was last at rest
    Levels levels;
    Levels next;                 ///< at the following evaluation
    double next_s = -1;          ///< time of next; negative before
    Levels last;                 ///< when its contacts last allowed no rigid motion, and it then slowed down
    Levels held;                 ///< when they last allowed none
    double held_at_m_per_s = 0;  ///< its speed then; 0 before
    int stood = 0;               ///< consecutive evaluations at rest
    double strains = 0;          ///< twice its speed when it last stood, if it strained then [m/s]
    double crept = 0;            ///< the same if it moved slower than that since, and counted as standing
    Vector6 displacement = Vector6::Zero();
    Point acceleration = Point::Zero();  ///< of its centroid at that time
    Vector6 seen = Vector6::Zero();      ///< displacement at the last evaluation
    Point velocity = Point::Zero();      ///< mean of the centroid's velocity between the last two evaluations
    bool failed = false;                 ///< or loose

    void sets_out_later(double at_s, const Levels& levels_then) {
      time_s = at_s;
      levels = last = levels_then;
      next_s = -1;
      held_at_m_per_s = 0;
    }

    /// Contacts that seem to hold, for a moment, what only grows faster do not hold it.
    void moves_on(double at_m_per_s, bool is_held, const Levels& levels_now) {
      if (at_m_per_s < held_at_m_per_s) last = held;
      if (is_held) held = levels_now, held_at_m_per_s = at_m_per_s;
    }

    template <class Archive>
    void serialize(Archive& archive) {
      archive(time_s, levels, next, next_s, last, held, held_at_m_per_s, stood, strains, crept, displacement,
              acceleration, seen, velocity, failed);
    }
  };
  void judge();
  void name_failures();
  [[nodiscard]] bool is_loose(std::size_t block) const;
  [[nodiscard]] double speed(std::size_t block) const;
  [[nodiscard]] double travel(std::size_t block) const;
  [[nodiscard]] bool strains(std::size_t block) const;
  [[nodiscard]] bool creeps(std::size_t block) const;
  [[nodiscard]] bool all_is_dry(double level_m) const;
  /// Whether the downstream pool's level counts for a body that was last at rest at `last`: if only that level changed
  /// afterwards; otherwise the higher pool's.
  [[nodiscard]] bool changing_pool(const Watched& last) const;
  [[nodiscard]] Failure describe(std::size_t block) const;
  void add_uncertainty(const Watched& last, Failure& failure) const;

  const Solid& solid_;
  std::vector<Watched> watched_;
  std::vector<bool> slow_;       ///< at the last evaluation
  std::vector<bool> stands_;     ///< slow, or without a possible rigid motion
  std::vector<double> slipped_;  ///< since each block was at rest, at the last evaluation [m]
  SlipsSinceRest slips_;
  std::vector<bool> unknown_;  ///< whether it has one was not checked, at the last evaluation
  bool at_rest_ = true;
  bool begun_ = false;
  double seen_s_ = 0;         ///< time of the last evaluation
  std::vector<bool> guided_;  ///< by supports at two points, or ground: its motion is not a failure
  std::vector<bool> crumbs_;
  bool loads_stay_ = false;  ///< nothing that acts changes with time: what fails would fail from the start
  std::vector<int> loose_;
  const bool strains_;  ///< does anything?
  const bool rings_;    ///< may velocities?
  std::vector<Failure> failures_;
};

}  // namespace blockweir::solid
