// SPDX-License-Identifier: GPL-3.0-or-later
// The added mass of all motions with all others, as the solid's guard receives it.
#pragma once

#include <array>
#include <vector>

#include "bridge/wire/message.hpp"
#include "fluid/reservoir/added_mass.hpp"

namespace blockweir::reservoir {

class GuardedMass {
 public:
  GuardedMass() = default;
  explicit GuardedMass(std::size_t motions) : own_(motions) {}

  /// Adds `share` of the added mass of one body of water; a block may touch several.
  void add(const WaterAnswer& answer, double share);
  void write(wire::Load& load) const;

 private:
  /// As wire::Load has it.
  struct Between {
    std::array<std::uint32_t, 2> pair;
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> mass;
  };

  void sum_up_pairs();

  std::vector<std::array<double, 6>> own_;  ///< as wire::Load has it
  std::vector<Between> between_;            ///< in the order of the pairs
};

}  // namespace blockweir::reservoir
