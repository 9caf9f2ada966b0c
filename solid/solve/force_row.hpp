// SPDX-License-Identifier: GPL-3.0-or-later
// Both forces of a contact, support or bolt as sweeps find them, and what they move.
#pragma once

#include <Eigen/Core>
#include <array>

#include "solid/contact/force_rule.hpp"

namespace blockweir::solid {

struct ForceRow {
  /// What one end meets: unknowns that follow each other.
  struct End {
    std::size_t first_entry = 0;  ///< of d gap, d slip / d unknowns, then of displacements by unit normal, unit shear
    int first = 0;
    int count = 0;  ///< 0: what does not move
  };
  std::array<End, 2> ends;
  Eigen::Vector2d apart = Eigen::Vector2d::Zero();  ///< gap and slip without a displacement [m]
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  Eigen::Matrix2d flexibility = Eigen::Matrix2d::Zero();   ///< of gap and slip, by the row's own forces
  Eigen::Vector2d force_before = Eigen::Vector2d::Zero();  ///< as the sweep before left it, or the nearest
  bool slips = false;                                      ///< shear is at its bound
  ForceRule rule{};
};

/// What a sweep has changed.
struct SweepProgress {
  double largest_m = 0;  ///< change of a gap or slip by a row's own forces
  double ahead = 0;      ///< above zero: the sweep has taken back what acceleration had gone ahead
};

}  // namespace blockweir::solid
