// SPDX-License-Identifier: GPL-3.0-or-later
// Four rows of sweeps that share no unknown: none feels what the others' forces move, so that a processor finds all
// four in the time of one.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solid/contact/force_rule.hpp"

namespace blockweir::solid {

constexpr int lanes = 4;
constexpr int most_unknowns = 6;  ///< of an end: those of a block
using Four = double __attribute__((vector_size(lanes * sizeof(double))));

/// What one end of each lane's row meets: a block's displacements, of a lane without a row those of no block.
struct BatchEnd {
  std::array<int, lanes> first{};
  int count = 0;                ///< of unknowns, at most most_unknowns
  std::size_t first_entry = 0;  ///< as of ForceRow::End
};

// Processors read wide vectors from addresses that are multiples of their size, whatever the compiler's default is.
struct alignas(sizeof(Four)) RowBatch {
  Four gap{};  ///< without a displacement [m]
  Four slip{};
  Four normal{};  ///< forces [N per metre]
  Four shear{};
  Four normal_before{};  ///< as the sweep before left them, or the nearest
  Four shear_before{};
  Four gap_by_normal{};  ///< by the row's own forces, without the rule's compliance
  Four gap_by_shear{};
  Four slip_by_shear{};
  PointForces<Four> forces;
  PointForces<Four>::Mask slips{};
  std::array<BatchEnd, 2> ends;
  std::array<int, lanes> row = {-1, -1, -1, -1};
  bool dry = true;  ///< the rules of all
};

/// Of four rows the same number.
struct alignas(sizeof(Four)) BatchEntry {
  Four of;
};

/// What sweeps have changed in each lane.
struct alignas(sizeof(Four)) BatchProgress {
  Four largest{};
  Four ahead{};

  void operator+=(const BatchProgress& other) {
    largest = largest > other.largest ? largest : other.largest;
    ahead += other.ahead;
  }
};

/// Visits the batches, from forces that go on by `by` times their last change, and go `part` of their way.
void sweep_batches(std::span<RowBatch> batches, const std::vector<BatchEntry>& entries, double by, double part,
                   double* displacement, BatchProgress& progress);

}  // namespace blockweir::solid
