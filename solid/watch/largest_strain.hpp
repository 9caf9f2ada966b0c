// SPDX-License-Identifier: GPL-3.0-or-later
// Warns of a block that is strained as no rock or concrete is, which small strains and a linear law do not describe.
#pragma once

#include <string>

#include "solid/step/solid.hpp"

namespace blockweir::solid {

class LargestStrain {
 public:
  void look(const Solid& solid, double time_s);
  /// Empty while no strain is large.
  [[nodiscard]] std::string warning(const Solid& solid) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(strain_, block_, time_s_);
  }

 private:
  double strain_ = 0;  ///< largest component of any block so far
  int block_ = 0;
  double time_s_ = 0;
};

}  // namespace blockweir::solid
