// SPDX-License-Identifier: GPL-3.0-or-later
// Block Gauss-Seidel on forces: each contact in turn gets the forces that fulfil its law while all others stand. After
// any number of sweeps forces are admissible, and displacements are those that they cause.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bridge/scene/at.hpp"
#include "solid/solve/force_row.hpp"
#include "solid/solve/row_batches.hpp"

namespace blockweir::solid {

class ForceSweeps {
 public:
  using Row = ForceRow;

  /// No rows, but room for so many, and displacements that there are without forces.
  /// Where blocks share unknowns sweeps are not accelerated: it threw a meshed dam on jointed rock.
  void begin(const Eigen::VectorXd& displacement, std::size_t rows, bool accelerates = true);
  Row& add_row() { return rows_.emplace_back(); }
  /// One end of the last row. Rows of `motions`: d (gap, slip) / d unknowns; columns of `responses`: displacements by
  /// unit forces.
  template <class Motions, class Responses>
  void add_end(bool second, Eigen::Index first, const Eigen::MatrixBase<Motions>& motions,
               const Eigen::MatrixBase<Responses>& responses);
  /// The same in two parts: room for an end of the last row, and what is in it, of several rows at once.
  void add_room(bool second, Eigen::Index first, Eigen::Index count);
  template <class Motions, class Responses>
  void set_end(Row& row, bool second, const Eigen::MatrixBase<Motions>& motions,
               const Eigen::MatrixBase<Responses>& responses);
  /// Rows are all there, with their rules: displacements by the forces that they have.
  void apply_forces();
  /// The same rows sweep other displacements, with rules that may be others.
  void displace(const Eigen::VectorXd& displacement);

  /// Each force once, from forces that go on as the last sweep changed them (Nesterov's acceleration), or that stand
  /// where that would lead away. Where that has long come no nearer, each force goes a part of the way. Largest change
  /// of a gap or slip by a row's own forces [m].
  double sweep();
  /// Sweeps until two in a row change no gap or slip by more than that [m]. Their number.
  int settle(int most, double enough_m);
  /// After sweeps of parts of the way, which come and go: forces and displacements as the nearest of them left them.
  /// What that left [m]; that of the last sweep where none was such.
  double take_nearest();
  /// By how much gaps and slips are off their laws [m].
  [[nodiscard]] double residual() const;
  [[nodiscard]] Eigen::Vector2d apart(const Row& row) const;

  [[nodiscard]] auto displacement() const { return displacement_.head(displacement_.size() - most_unknowns); }
  /// Of an end, a column each for gap and slip: what they gain by unit displacements.
  [[nodiscard]] Eigen::Map<const Eigen::MatrixX2d> motions(const Row::End& end) const;
  [[nodiscard]] std::vector<Row>& rows() { return rows_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  /// Of an end: a column each for normal and shear.
  using Entries = Eigen::Map<const Eigen::MatrixX2d>;

  void begin_sweeps();
  double sweep_once();
  double sweep_ahead();
  double sweep_part_way();
  void go_on(double beyond);
  void keep();
  void visit(std::size_t alone, SweepProgress& progress);
  void act(const Row& row, const Eigen::Vector2d& force);
  [[nodiscard]] Entries responses(const Row::End& end) const;

  std::vector<Row> rows_;
  std::vector<double> entries_;
  RowBatches batches_;
  std::vector<PointForces<double>> alone_;  ///< of the rows that batches leave alone
  Eigen::VectorXd displacement_;            ///< and zeros, of what does not move
  Eigen::VectorXd displacement_before_;     ///< as the sweep before left them, or the nearest of those part of the way
  double momentum_ = 1;
  bool accelerates_ = true;
  bool rows_are_new_ = true;
  double least_m_ = 0;      ///< that a sweep has changed since acceleration began
  double milestone_m_ = 0;  ///< of the last sweep that came much nearer
  double nearest_m_ = 0;    ///< of sweeps of parts of the way
  double last_m_ = 0;
  int in_vain_ = 0;  ///< sweeps since the milestone
  double part_ = 1;  ///< of its way that a force goes
};

template <class Motions, class Responses>
void ForceSweeps::add_end(bool second, Eigen::Index first, const Eigen::MatrixBase<Motions>& motions,
                          const Eigen::MatrixBase<Responses>& responses) {
  add_room(second, first, motions.cols());
  set_end(rows_.back(), second, motions, responses);
}

template <class Motions, class Responses>
void ForceSweeps::set_end(Row& row, bool second, const Eigen::MatrixBase<Motions>& motions,
                          const Eigen::MatrixBase<Responses>& responses) {
  double* to = entries_.data() + row.ends[second ? 1 : 0].first_entry;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    for (Eigen::Index i = 0; i < motions.cols(); ++i) *to++ = motions(axis, i);
  }
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    for (Eigen::Index i = 0; i < motions.cols(); ++i) *to++ = responses(i, axis);
  }
  row.flexibility += motions * responses;
}

}  // namespace blockweir::solid
