// SPDX-License-Identifier: GPL-3.0-or-later
// When has a structure failed, at which level, and how? Found from the motion, not from a threshold on the load.
//
// A block is at rest while no vertex is faster than rest_speed_m_per_s, or up to a hundred times that while blocks at
// rest hold it (one contact sticks, another is closed): then it strains under a load that comes fast. A motion that
// carries a vertex farther than failure_displacement_m without coming to rest in between is a failure: elastic settling
// and a slip that finds a new equilibrium both come to rest before. The failure began, and the level is read, at the
// last rest. A block that turns overturns, one whose contacts slip slides, and it may do both.
#pragma once

#include "bridge/scene/joint_trace.hpp"
#include "solid/output/frame.hpp"
#include "solid/step/solid.hpp"

namespace blockweir::solid::output {

struct Failure {
  int block = 0;
  double time_s = 0;   ///< last rest
  double level_m = 0;  ///< upstream level that acted then; NaN without a pool
  double head_m = 0;   ///< of it above the upstream end of the joint that failed; NaN without a pool
  std::string mode;    ///< "sliding", "overturning", "sliding and overturning" or "falling"
  std::string joint;   ///< what the block moves against; empty when it falls free

  template <class Archive>
  void serialize(Archive& archive) {
    archive(block, time_s, level_m, head_m, mode, joint);
  }
};

class FailureWatch {
 public:
  explicit FailureWatch(const Solid& solid);

  /// Looks at the state at `time_s`, reached under `upstream_level_m`.
  void look(double time_s, double upstream_level_m);

  /// Every block is at rest.
  [[nodiscard]] bool calm() const;

  /// Failures so far, the earliest first.
  [[nodiscard]] const std::vector<Failure>& failures() const { return failures_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(rest_, failures_);
  }

 private:
  struct Rest {
    double time_s = 0;
    double level_m = 0;
    Vector6 displacement = Vector6::Zero();
    bool failed = false;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(time_s, level_m, displacement, failed);
    }
  };
  [[nodiscard]] double speed(std::size_t block) const;
  [[nodiscard]] bool held(std::size_t block, const std::vector<const ContactPoint*>& closed,
                          const std::vector<bool>& resting) const;
  [[nodiscard]] std::vector<bool> resting() const;
  [[nodiscard]] double travel(std::size_t block) const;
  [[nodiscard]] double slip(std::size_t block, std::size_t other) const;
  [[nodiscard]] Failure describe(std::size_t block) const;
  [[nodiscard]] int neighbour_left_behind(std::size_t block) const;
  [[nodiscard]] scene::JointTrace joint_trace(std::size_t a, std::size_t b) const;

  const Solid& solid_;
  std::vector<Rest> rest_;
  std::vector<bool> guided_;  ///< by supports at two of its points: how it moves is the scene's will, no failure
  std::vector<Failure> failures_;
};

}  // namespace blockweir::solid::output
