// SPDX-License-Identifier: GPL-3.0-or-later
// The added mass of all motions with all others, as the solid's guard receives it.
#pragma once

#include <map>

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
  std::vector<std::array<double, 6>> own_;  ///< as wire::Load has it
  std::map<std::array<std::uint32_t, 2>, Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> between_;  ///< likewise
};

}  // namespace blockweir::reservoir
