// SPDX-License-Identifier: GPL-3.0-or-later
// How far blocks have slipped since they were last at rest. Strain moves a structure at any speed, but its joints slip
// and open by little meanwhile.
#pragma once

#include <vector>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

class SlipsSinceRest {
 public:
  explicit SlipsSinceRest(const Solid& solid)
      : solid_(solid), at_(solid.described(), Vector6::Zero()), s_(at_.size()) {}

  /// The block is at rest now.
  void rests(std::size_t block) {
    at_[block] = solid_.states()[block].displacement;
    s_[block] = solid_.time_s();
  }
  /// For each block, the largest way by which points that touch, or have touched, have come apart [m].
  [[nodiscard]] std::vector<double> largest() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(at_, s_);
  }

 private:
  const Solid& solid_;
  std::vector<Vector6> at_;  ///< displacement
  std::vector<double> s_;    ///< time
};

}  // namespace blockweir::solid
