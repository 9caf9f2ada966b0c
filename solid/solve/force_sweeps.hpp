// SPDX-License-Identifier: GPL-3.0-or-later
// Block Gauss-Seidel on forces: each contact in turn gets the forces that fulfil its law while all others stand. After
// any number of sweeps forces are admissible, and displacements are those that they cause.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bridge/scene/at.hpp"
#include "solid/contact/force_rule.hpp"

namespace blockweir::solid {

class ForceSweeps {
 public:
  /// What one end of a force meets: unknowns that follow each other.
  struct End {
    std::size_t first_entry = 0;  ///< of its motions, then responses
    int first = 0;
    int count = 0;  ///< 0: what does not move
  };
  /// In the order of a visit, what none reads last.
  struct Row {
    std::array<End, 2> ends;
    Eigen::Vector2d apart = Eigen::Vector2d::Zero();  ///< gap and slip without a displacement [m]
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    Eigen::Matrix2d flexibility = Eigen::Matrix2d::Zero();   ///< of gap and slip, by the row's own forces
    PointForces forces{};                                    ///< by the rule, as sweeps have them
    Eigen::Vector2d force_before = Eigen::Vector2d::Zero();  ///< as the sweep before left it, or the nearest
    bool slips = false;                                      ///< shear is at its bound
    ForceRule rule{};
  };

  /// No rows, but room for so many, and displacements that there are without forces.
  /// Where blocks share unknowns sweeps are not accelerated: it threw a meshed dam on jointed rock.
  void begin(const Eigen::VectorXd& displacement, std::size_t rows, bool accelerates = true);
  Row& add_row() { return rows_.emplace_back(); }
  /// One end of the last row. Rows of `motions`: d (gap, slip) / d unknowns; columns of `responses`: displacements by
  /// unit forces.
  template <class Motions, class Responses>
  void add_end(bool second, Eigen::Index first, const Eigen::MatrixBase<Motions>& motions,
               const Eigen::MatrixBase<Responses>& responses);
  /// Rows are all there, with their rules: displacements by the forces that they have.
  void let_act();
  /// The same rows sweep other displacements, with rules that may be others.
  void displace(const Eigen::VectorXd& displacement);

  /// Each force once, from forces that go on as the last sweep changed them (Nesterov's acceleration), or that stand
  /// where that would lead away. Where that has long come no nearer, each force goes a part of the way. Largest change
  /// of a gap or slip by a row's own forces [m].
  /// Of rows without a force most sweeps look only at those that the last look at all has found pressed.
  double sweep();
  /// Sweeps until two in a row, the second of all rows, change no gap or slip by more than that [m]. Their number.
  int settle(int most, double enough_m);
  /// After sweeps of parts of the way, which come and go: forces and displacements as the nearest of them left them.
  /// What that left [m]; that of the last sweep where none was such.
  double take_nearest();
  /// By how much gaps and slips are off their laws [m].
  [[nodiscard]] double residual() const;
  [[nodiscard]] Eigen::Vector2d apart(const Row& row) const;

  [[nodiscard]] const Eigen::VectorXd& displacement() const { return displacement_; }
  [[nodiscard]] std::vector<Row>& rows() { return rows_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  struct Progress {
    double largest_m = 0;  ///< change of a gap or slip
    double ahead = 0;      ///< above zero: the sweep has taken back what acceleration had gone ahead
  };
  struct Apart {
    double gap = 0;
    double slip = 0;
  };
  void begin_sweeps();
  [[nodiscard]] inline Apart moved(const Row& row, Apart now) const;
  double sweep_ahead();
  double sweep_part_way();
  void go_on(double beyond);
  void choose_rows();
  void keep();
  void visit(Row& row, Progress& progress);
  inline void act(const Row& row, double normal, double shear);

  std::vector<Row> rows_;
  std::vector<int> acting_;  ///< rows that had a force as all were looked at last, or got one
  std::vector<double> entries_;
  Eigen::VectorXd displacement_;
  Eigen::VectorXd displacement_before_;  ///< as the sweep before left them, or the nearest of those part of the way
  double momentum_ = 1;
  bool accelerates_ = true;
  double least_m_ = 0;    ///< that a sweep has changed since acceleration began
  double nearest_m_ = 0;  ///< that any has
  double last_m_ = 0;
  double enough_m_ = 0;
  int sweeps_ = 0;        ///< of the same displacements
  bool saw_all_ = false;  ///< did the last one?
  int in_vain_ = 0;       ///< sweeps that came no nearer
  double part_ = 1;       ///< of its way that a force goes
};

template <class Motions, class Responses>
void ForceSweeps::add_end(bool second, Eigen::Index first, const Eigen::MatrixBase<Motions>& motions,
                          const Eigen::MatrixBase<Responses>& responses) {
  Row& row = rows_.back();
  row.ends[second ? 1 : 0] = {entries_.size(), static_cast<int>(first), static_cast<int>(motions.cols())};
  entries_.resize(entries_.size() + at(4 * motions.cols()));
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
