// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of joints in tension whose uplift law assumes them closed: water in a crack has the pressure of its mouth.
#pragma once

#include <optional>

#include "solid/watch/failure_watch.hpp"
#include "solid/watch/joint_table.hpp"
#include "solid/watch/surface_sum.hpp"

namespace blockweir::solid {

/// A warning for each row in tension over more than 1 % of its length whose uplift does not follow the crack:
/// "drained", "triangular", "flow", "heads" and "none", if the end that opens lies below its pool's level.
std::vector<std::string> uplift_warnings(const scene::Scene& scene, const Levels& levels,
                                         const std::vector<JointRow>& rows);

/// The same of the surfaces of a run, until something fails. Lengths of galleries are left out.
class OpenedJoints {
 public:
  /// `sums`: of these surfaces, in the state that these levels load.
  void look(const Surfaces& surfaces, const std::vector<SurfaceSum>& sums, const Levels& levels);

  /// Of the joint that has opened farthest, and of how many others; empty where none has.
  [[nodiscard]] std::string warning(const scene::Scene& scene) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(opened_);
  }

 private:
  struct Opened {
    std::string name;
    Point upstream_end_m;
    Point downstream_end_m;
    double from_level_m = 0;   ///< of the pool at its mouth, where it opened
    double worst_level_m = 0;  ///< where it was open farthest
    double share = 0;          ///< largest so far; 0: closed

    template <class Archive>
    void serialize(Archive& archive) {
      archive(name, upstream_end_m, downstream_end_m, from_level_m, worst_level_m, share);
    }
  };
  std::vector<Opened> opened_;  ///< by surface; empty before the first look
};

}  // namespace blockweir::solid
