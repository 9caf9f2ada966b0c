// SPDX-License-Identifier: GPL-3.0-or-later
// A linear program that is built row by row and column by column, and solved by the simplex method (GLPK).
#pragma once

#include <limits>
#include <memory>
#include <utility>
#include <vector>

struct glp_prob;

namespace blockweir::solid::limit {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

enum class ProgramStatus { optimal, infeasible };

/// Scale variables and rows to the order of one: the tolerances, 1e-10, are absolute.
class LinearProgram {
 public:
  using Entries = std::vector<std::pair<int, double>>;  ///< row and coefficient

  LinearProgram();

  /// Both return the new row's number.
  int add_equation(double right_side);
  int add_upper_bound(double right_side);
  /// Bounds may be infinite. Entries of the same row are added up; a sum that is only round-off counts as zero. Returns
  /// the new variable's number.
  int add_variable(double low, double high, Entries entries, double objective = 0);

  /// Throws std::runtime_error if the simplex method does not end, for example if the objective is unbounded.
  ProgramStatus maximize();

  [[nodiscard]] double value(int variable) const;
  /// Derivative of the objective with respect to the row's right side.
  [[nodiscard]] double dual(int row) const;

 private:
  int solve(int method);
  void relax(double size, unsigned seed);
  [[nodiscard]] bool is_optimal() const;

  std::unique_ptr<glp_prob, void (*)(glp_prob*)> program_;
  std::vector<std::pair<int, double>> upper_;  ///< rows with an upper bound
  std::vector<std::pair<int, double>> lower_;  ///< variables with a lower bound only
};

}  // namespace blockweir::solid::limit
