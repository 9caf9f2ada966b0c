// SPDX-License-Identifier: GPL-3.0-or-later
// Projects the positions of rigid bodies onto those without overlap, in the metric of their masses: the complementarity
// problem 0 <= gap _|_ push >= 0.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

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
  /// `mass` of each body against (x, y, turn).
  OverlapProjection(const std::vector<Eigen::Vector3d>& mass, const std::vector<Overlap>& overlaps);

  /// Projected Gauss-Seidel there and back with Nesterov's acceleration, begun anew where it turns back (O'Donoghue and
  /// Candes 2015). Ends when every gap is within half of tolerance_m of its target, or after a bounded
  /// number of sweeps.
  void solve(double tolerance_m);

  [[nodiscard]] const Eigen::Vector3d& moved(std::size_t body) const { return moved_[body]; }
  /// Overlap that is left [m].
  [[nodiscard]] double deepest() const;

 private:
  /// Both ends of an overlap; what does not move is the last body, and is not moved.
  struct Row {
    double gap = 0;
    double flexibility = 0;  ///< d gap / d push
    double push = 0;
    double push_before = 0;  ///< as the sweeps before left it
    std::array<int, 2> body{};
    std::array<Eigen::Vector3d, 2> opens{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    std::array<Eigen::Vector3d, 2> moves{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  ///< by a unit push
  };
  struct Progress {
    double largest_m = 0;  ///< change of a gap by its own push
    double ahead = 0;      ///< above zero: sweeps have taken back what acceleration had gone ahead
  };

  [[nodiscard]] double gap(const Row& row) const;
  void choose_rows(double tolerance_m);
  void visit(Row& row, double tolerance_m, Progress& progress);
  void go_on(double beyond);

  std::vector<Row> rows_;
  std::vector<std::size_t> acting_;  ///< rows that are pushed, or may be
  std::vector<char> touched_;        ///< has a body been moved?
  int sweeps_ = 0;
  bool saw_all_ = false;  ///< did the last sweep look at all that may be pushed?
  double last_m_ = std::numeric_limits<double>::infinity();
  std::vector<Eigen::Vector3d> moved_;
  std::vector<Eigen::Vector3d> moved_before_;
};

}  // namespace blockweir::solid
