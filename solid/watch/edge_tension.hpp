// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bond of blocks without a mesh bears more tension than an elastic joint would at its edge.
//
// Their bond acts at the joint's two ends, half of its strength at each. A stress that is linear along the joint
// reaches the strength at the edge before, in bending alone at a third of the load: a brittle bond would crack there.
#pragma once

#include <string>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

class EdgeTension {
 public:
  /// Looks at the state at `time_s`, reached under this level of the higher pool.
  void look(const Solid& solid, double time_s, double level_m);

  /// Largest stress at an edge so far over the joint's tension strength; 0 where no bond is in tension.
  [[nodiscard]] double ratio() const { return ratio_; }
  /// Empty where no bond bears more than its strength at its edge.
  [[nodiscard]] std::string warning() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(ratio_, stress_pa_, time_s_, level_m_, joint_);
  }

 private:
  double ratio_ = 0;
  double stress_pa_ = 0;
  double time_s_ = 0;
  double level_m_ = 0;  ///< NaN without a pool
  std::string joint_;
};

}  // namespace blockweir::solid
