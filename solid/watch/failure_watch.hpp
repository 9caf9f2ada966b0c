// SPDX-License-Identifier: GPL-3.0-or-later
// When has a structure failed, at which level, and how? Found from the motion, not from a threshold on the load.
//
// A block stands while no vertex is faster than rest_speed_m_per_s, or while the contacts leave it no rigid motion of
// its own (mobility.hpp) for some looks in a row: then it strains under a load that comes fast, or rings, at any speed.
// A motion that carries a vertex farther than failure_displacement_m without standing in between is a failure: a slip
// that finds a new equilibrium stands before. The failure began, and the level is read, when the block last stood.
#pragma once

#include "bridge/scene/joint_trace.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid {

/// Of the pools, where there are any [m]; NaN where not.
struct Levels {
  double upstream_m = std::numeric_limits<double>::quiet_NaN();
  double downstream_m = std::numeric_limits<double>::quiet_NaN();

  /// The downstream pool stands higher: the structure is pushed upstream.
  [[nodiscard]] bool reversed() const { return !std::isnan(downstream_m) && !(upstream_m >= downstream_m); }
  [[nodiscard]] double of(bool downstream) const { return downstream ? downstream_m : upstream_m; }
  [[nodiscard]] double higher_m() const { return of(reversed()); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(upstream_m, downstream_m);
  }
};

/// Of blocks that move as one body.
struct Failure {
  std::vector<int> blocks;  ///< in the scene's order
  double time_s = 0;        ///< when it last stood
  double level_m = 0;       ///< of a pool then: changing_pool(); NaN without a pool, or below all that can move
  bool downstream = false;  ///< that is the downstream one
  bool falls = false;       ///< its level was going down
  double head_m = 0;        ///< of it above the end of the joint that failed on its side; NaN without a pool
  bool bound = false;  ///< it has not stood at any level before: that of failure is at most this, at least if it falls
  /// The level's rise in a window and while the body was too slow to be seen, and what it rose by while it stuck from
  /// time to time, or what inertia stands for: a fast filling, a structure that rings. NaN likewise, and for a bound.
  double level_uncertainty_m = 0;
  double window_rise_m = 0;  ///< the first part of it
  double travel_m = 0;       ///< when the failure was certain
  std::string mode;          ///< "sliding", "overturning", "sliding and overturning", "lifting" or "falling"
  std::string joint;         ///< what the body moves against; empty when it falls free

  template <class Archive>
  void serialize(Archive& archive) {
    archive(blocks, time_s, level_m, downstream, falls, head_m, bound, level_uncertainty_m, window_rise_m, travel_m,
            mode, joint);
  }
};

/// A block that moves and has not failed yet.
struct Moving {
  int block = 0;
  double speed_m_per_s = 0;
  double travel_m = 0;  ///< since it last stood
};

class FailureWatch {
 public:
  explicit FailureWatch(const Solid& solid);

  /// Looks at the state at `time_s`, reached under these levels.
  void look(double time_s, const Levels& levels);

  /// At the last look every block was at rest, or strained slowly.
  [[nodiscard]] bool calm() const { return calm_; }

  /// Failures so far, the earliest first.
  [[nodiscard]] const std::vector<Failure>& failures() const { return failures_; }

  /// All that failed was at rest at the last look.
  [[nodiscard]] bool rests_again() const;

  /// Farthest that a vertex of what failed is from where it was drawn, against the base [m].
  [[nodiscard]] double farthest_failed_m() const;

  /// The fastest block that neither stands nor has failed; none where there is none.
  [[nodiscard]] std::optional<Moving> moving() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(watched_, slow_, stands_, calm_, begun_, seen_s_, failures_);
  }

 private:
  struct Watched {
    double time_s = 0;  ///< when the block last stood
    Levels levels;
    Levels next;         ///< at the look after that
    double next_s = -1;  ///< its time; negative before
    Levels last;         ///< when contacts last left it no motion since then
    int stood = 0;       ///< looks in a row
    Vector6 displacement = Vector6::Zero();
    Point acceleration = Point::Zero();  ///< of its centroid, then
    Vector6 seen = Vector6::Zero();      ///< displacement at the last look
    Point velocity = Point::Zero();      ///< mean of the centroid's between the last two looks
    bool failed = false;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(time_s, levels, next, next_s, last, stood, displacement, acceleration, seen, velocity, failed);
    }
  };
  void judge();
  [[nodiscard]] double speed(std::size_t block) const;
  [[nodiscard]] double travel(std::size_t block) const;
  [[nodiscard]] bool sets_out(std::size_t block) const;
  [[nodiscard]] bool all_is_dry(double level_m) const;
  /// Is the downstream pool the one by which a body failed that stood then: the only one whose level went on to change;
  /// else the higher.
  [[nodiscard]] bool changing_pool(const Watched& last) const;
  [[nodiscard]] Failure describe(std::size_t block) const;
  void add_uncertainty(const Watched& last, Failure& failure) const;

  const Solid& solid_;
  std::vector<Watched> watched_;
  std::vector<bool> slow_;    ///< at the last look
  std::vector<bool> stands_;  ///< slow, or without a rigid motion of its own
  bool calm_ = true;
  bool begun_ = false;
  bool rings_ = false;        ///< velocities along held directions may flip from step to step
  double seen_s_ = 0;         ///< time of the last look
  std::vector<bool> guided_;  ///< by supports at two of its points, or ground: how it moves is no failure
  std::vector<Failure> failures_;
};

}  // namespace blockweir::solid
