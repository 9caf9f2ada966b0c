// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of sweeps in batches of four. The graph of contacts is coloured: rows of one colour share no unknown, and
// colours follow each other.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "solid/solve/force_row.hpp"
#include "solid/solve/parts.hpp"
#include "solid/solve/row_batch.hpp"

namespace blockweir::solid {

class RowBatches {
 public:
  /// Rows of blocks that move by themselves; `entries` as the rows have them. Ends that do not move get the
  /// displacements from `nowhere` on, which stay zero.
  void choose(const std::vector<ForceRow>& rows, const std::vector<double>& entries, Eigen::Index nowhere);
  /// Rows of which an end has more than most_unknowns, or both ends have the same.
  [[nodiscard]] const std::vector<int>& left_alone() const { return left_alone_; }

  /// Gaps, slips, forces and rules as the rows have them.
  void begin(const std::vector<ForceRow>& rows);
  /// Each force once, from forces that go on by so much of what the last sweep has changed, and a part of its way.
  void sweep(double by, double part, double* displacement, SweepProgress& progress);
  /// Notes forces as they are; and goes back to them.
  void keep();
  void take_kept();
  /// Forces, and which slip.
  void give_back(std::vector<ForceRow>& rows) const;

 private:
  using Ends = std::array<int, 4>;  ///< first unknown and their number, of both

  [[nodiscard]] bool are_coloured(const std::vector<ForceRow>& rows) const;
  void colour(const std::vector<ForceRow>& rows, Eigen::Index nowhere);
  void add_batches(const std::vector<int>& colour, const std::vector<ForceRow>& rows);
  static void begin(RowBatch& batch, const std::vector<ForceRow>& rows);
  void fill(const RowBatch& batch, const std::vector<ForceRow>& rows, const std::vector<double>& entries);

  std::vector<RowBatch> batches_;
  EndsOfParts ends_of_parts_{};  ///< among the batches; the last: of what joins them
  std::vector<BatchEntry> entries_;
  std::vector<int> left_alone_;
  std::vector<Ends> coloured_;  ///< of the rows for which batches were chosen
  Eigen::Index nowhere_ = -1;
};

}  // namespace blockweir::solid
