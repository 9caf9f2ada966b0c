// SPDX-License-Identifier: GPL-3.0-or-later
// Projects the positions of rigid bodies onto those without overlap, in the metric of their masses: the complementarity
// problem 0 <= gap _|_ push >= 0.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

#include "solid/solve/overlap_batch.hpp"
#include "solid/solve/parts.hpp"

namespace blockweir::solid {

/// Where two bodies, or a body and what does not move, may overlap.
struct Overlap {
  struct End {
    int body = -1;                                    ///< -1: does not move
    Eigen::Vector3d opens = Eigen::Vector3d::Zero();  ///< d gap / d (x, y, turn)
  };
  double gap = 0;  ///< m
  std::array<End, 2> ends;
};

class OverlapProjection {
 public:
  /// `mass` of each body against (x, y, turn), the same for x and y.
  OverlapProjection(const std::vector<Eigen::Vector3d>& mass, const std::vector<Overlap>& overlaps);

  /// Projected Gauss-Seidel there and back with Nesterov's acceleration, begun anew where it turns back (O'Donoghue and
  /// Candes 2015). Aims at half of tolerance_m of overlap. Ends when no overlap is above tolerance_m and nothing is
  /// pushed farther than that, or after a bounded number of sweeps.
  void solve(double tolerance_m);

  [[nodiscard]] Eigen::Vector3d moved(std::size_t body) const { return Eigen::Vector3d::Map(&moved_[3 * body]); }
  /// Overlap that is left [m].
  [[nodiscard]] double deepest() const;

 private:
  void add_part(int p, const std::vector<int>& part, const std::vector<std::array<int, 2>>& bodies,
                const std::vector<int>& numbers, std::vector<std::array<int, lanes>>& of_batch) const;
  void fill(OverlapBatch& batch, const std::vector<Eigen::Vector3d>& mass, const std::vector<Overlap>& overlaps,
            const std::array<int, lanes>& numbers) const;
  [[nodiscard]] bool is_solved(double tolerance_m) const;
  [[nodiscard]] bool may_be_pushed(const OverlapBatch& batch, double tolerance_m) const;
  void choose(double tolerance_m);
  void find_acting_parts();
  void push_there(double beyond, double aim, OverlapProgress& progress);
  void push_back(double aim, OverlapProgress& progress);

  std::vector<OverlapBatch> batches_;
  EndsOfParts ends_of_parts_{};      ///< among the batches; the last: of what joins them
  std::vector<char> may_act_;        ///< each batch
  std::vector<std::size_t> acting_;  ///< batches that are pushed, or may be
  EndsOfParts ends_of_acting_{};     ///< of the parts among these
  int sweeps_ = 0;
  bool saw_all_ = false;  ///< did the last sweep look at all that may be pushed?
  double last_m_ = std::numeric_limits<double>::infinity();
  std::vector<double> moved_;  ///< (x, y, turn) of each body, and of one for all that does not move
  std::vector<double> moved_before_;
};

}  // namespace blockweir::solid
