// SPDX-License-Identifier: GPL-3.0-or-later
// Four overlaps of which none moves what another moves, found in the time of one.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solid/solve/row_batch.hpp"

namespace blockweir::solid {

/// A lane without an overlap has a gap that nothing closes.
struct alignas(sizeof(Four)) OverlapBatch {
  /// What one end of each lane's overlap moves, by (x, y, turn): three numbers from `first` on.
  struct alignas(sizeof(Four)) End {
    std::array<Four, 3> opens{};  ///< d gap / d displacement
    std::array<Four, 2> per_mass{};
    std::array<int, lanes> first{};
  };
  Four gap{};          ///< m
  Four flexibility{};  ///< d gap / d push
  Four push{};
  Four push_before{};  ///< as the sweeps before left it
  std::array<End, 2> ends;
};

/// What pushes have changed in each lane.
struct alignas(sizeof(Four)) OverlapProgress {
  Four largest{};  ///< gap, by its own push
  Four ahead{};    ///< above zero: pushes have taken back what acceleration had gone ahead

  void operator+=(const OverlapProgress& other) {
    largest = largest > other.largest ? largest : other.largest;
    ahead += other.ahead;
  }
};

/// Pushes those of `acting`, in that order, from pushes that go on by `beyond` times their last change: each overlap
/// has `aim` left, or more.
void push_batches(std::vector<OverlapBatch>& batches, std::span<const std::size_t> acting, double beyond, double aim,
                  double* displacement, OverlapProgress& progress);
/// The same from the last to the first, from pushes as they are.
void push_batches_back(std::vector<OverlapBatch>& batches, std::span<const std::size_t> acting, double aim,
                       double* displacement, OverlapProgress& progress);
/// Gap of each lane as displacements have it.
[[nodiscard]] Four gap_of(const OverlapBatch& batch, const double* displacement);

}  // namespace blockweir::solid
