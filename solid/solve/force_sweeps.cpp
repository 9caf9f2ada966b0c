// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/force_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace blockweir::solid {

void ForceSweeps::begin(const Eigen::VectorXd& displacement, std::size_t rows, bool accelerates) {
  accelerates_ = accelerates;
  rows_.clear();
  rows_.reserve(rows);
  entries_.clear();
  displacement_ = displacement;
}

void ForceSweeps::begin_sweeps() {
  for (Row& row : rows_) {
    row.forces = PointForces(row.rule, row.flexibility);
    row.force_before = row.force;
  }
  displacement_before_ = displacement_;
  momentum_ = 1;
  nearest_m_ = least_m_ = std::numeric_limits<double>::infinity();
  in_vain_ = 0;
  part_ = 1;
  sweeps_ = 0;
  last_m_ = std::numeric_limits<double>::infinity();
}

void ForceSweeps::displace(const Eigen::VectorXd& displacement) {
  displacement_ = displacement;
  begin_sweeps();
}

void ForceSweeps::let_act() {
  for (const Row& row : rows_) act(row, row.force[0], row.force[1]);
  begin_sweeps();
}

void ForceSweeps::act(const Row& row, double normal, double shear) {
  for (const End& end : row.ends) {
    const double* by_normal = entries_.data() + end.first_entry + 2 * end.count;
    const double* by_shear = by_normal + end.count;
    double* moved = displacement_.data() + end.first;
    if (end.count == 3) {  // of rigid blocks, most of what is swept: no loop
      const std::array<double, 3> sum = {moved[0] + (normal * by_normal[0] + shear * by_shear[0]),
                                         moved[1] + (normal * by_normal[1] + shear * by_shear[1]),
                                         moved[2] + (normal * by_normal[2] + shear * by_shear[2])};
      std::copy(sum.begin(), sum.end(), moved);
      continue;
    }
    for (Eigen::Index i = 0; i < end.count; ++i) moved[i] += normal * by_normal[i] + shear * by_shear[i];
  }
}

/// What displacements add to these.
ForceSweeps::Apart ForceSweeps::moved(const Row& row, Apart now) const {
  for (const End& end : row.ends) {
    const double* of_gap = entries_.data() + end.first_entry;
    const double* of_slip = of_gap + end.count;
    const double* moved = displacement_.data() + end.first;
    if (end.count == 3) {
      now.gap += of_gap[0] * moved[0] + of_gap[1] * moved[1] + of_gap[2] * moved[2];
      now.slip += of_slip[0] * moved[0] + of_slip[1] * moved[1] + of_slip[2] * moved[2];
      continue;
    }
    for (Eigen::Index i = 0; i < end.count; ++i) {
      now.gap += of_gap[i] * moved[i];
      now.slip += of_slip[i] * moved[i];
    }
  }
  return now;
}

Eigen::Vector2d ForceSweeps::apart(const Row& row) const {
  const Apart now = moved(row, {row.apart[0], row.apart[1]});
  return {now.gap, now.slip};
}

/// In scalars: a pair that has just been written one by one is read slowly as one. Each visit waits for what the one
/// before has moved: what does not depend on that comes first.
void ForceSweeps::visit(Row& row, Progress& progress) {
  const Eigen::Matrix2d& W = row.flexibility;
  const double normal = row.force[0];
  const double shear = row.force[1];
  const Apart without = moved(
      row, {row.apart[0] - (W(0, 0) * normal + W(0, 1) * shear), row.apart[1] - (W(1, 0) * normal + W(1, 1) * shear)});
  const PointForces::Found found = row.forces.at(without.gap, without.slip);
  double more_normal = found.normal - normal;
  double more_shear = found.shear - shear;
  if (part_ != 1) {
    more_normal *= part_;
    more_shear *= part_;
  }
  row.slips = found.slips;
  if (more_normal == 0 && more_shear == 0) return;
  row.force[0] = part_ == 1 ? found.normal : normal + more_normal;
  row.force[1] = part_ == 1 ? found.shear : shear + more_shear;
  act(row, more_normal, more_shear);
  progress.ahead -= W(0, 0) * more_normal * (row.force[0] - row.force_before[0]) +
                    W(1, 1) * more_shear * (row.force[1] - row.force_before[1]);
  progress.largest_m = std::max({progress.largest_m, std::abs(W(0, 0) * more_normal + W(0, 1) * more_shear),
                                 std::abs(W(1, 0) * more_normal + W(1, 1) * more_shear)});
}

/// All forces, and what they displace, by so much of what the last sweep has changed.
void ForceSweeps::go_on(double beyond) {
  for (const int k : acting_) {
    Row& row = rows_[at(k)];
    const Eigen::Vector2d now = row.force;
    row.force += beyond * (now - row.force_before);
    row.force_before = now;
  }
  for (Eigen::Index i = 0; i < displacement_.size(); ++i) {
    const double now = displacement_[i];
    displacement_[i] += beyond * (now - displacement_before_[i]);
    displacement_before_[i] = now;
  }
}

/// Half of the rows are contacts that stay open: they are looked at in every tenth sweep, and before an end.
void ForceSweeps::choose_rows() {
  constexpr int between = 10;
  saw_all_ = sweeps_++ % between == 0 || part_ != 1 || last_m_ <= enough_m_;
  if (!saw_all_) return;
  acting_.resize(rows_.size());
  std::iota(acting_.begin(), acting_.end(), 0);
}

int ForceSweeps::settle(int most, double enough_m) {
  enough_m_ = enough_m;
  double before_m = std::numeric_limits<double>::infinity();  // acceleration turns: two sweeps are to be near
  for (int n = 1; n <= most; ++n) {
    const double left_m = sweep();
    if (saw_all_ && std::max(left_m, before_m) <= enough_m) return n;
    before_m = left_m;
  }
  return most;
}

double ForceSweeps::sweep() {
  constexpr int patience = 50;
  constexpr double part = 0.7;
  if (part_ == 1 && in_vain_ >= patience) {
    part_ = part;
    nearest_m_ = std::numeric_limits<double>::infinity();
  }
  choose_rows();
  return last_m_ = part_ == 1 ? sweep_ahead() : sweep_part_way();
}

/// Acceleration begins anew where it turns back (O'Donoghue and Candes 2015), or where forces begin to grow: friction
/// makes the problem unsymmetric.
double ForceSweeps::sweep_ahead() {
  constexpr double grows = 2;     // above the least since it began
  constexpr double nearer = 0.9;  // of the nearest
  const double next = (1 + std::sqrt(1 + 4 * momentum_ * momentum_)) / 2;
  go_on((momentum_ - 1) / next);
  if (accelerates_) momentum_ = next;
  Progress progress;
  for (const int k : acting_) visit(rows_[at(k)], progress);
  if (saw_all_) {
    std::erase_if(acting_, [&](int k) {
      const Row& row = rows_[at(k)];
      return row.force.isZero(0) && row.force_before.isZero(0);
    });
  }
  least_m_ = std::min(least_m_, progress.largest_m);
  if (progress.ahead > 0 || progress.largest_m > grows * least_m_) {
    momentum_ = 1;
    least_m_ = progress.largest_m;
  }
  ++in_vain_;
  if (progress.largest_m < nearer * nearest_m_) {
    nearest_m_ = progress.largest_m;
    in_vain_ = 0;
  }
  return progress.largest_m;
}

/// Where friction jams blocks, forces that go all of their way run in circles.
double ForceSweeps::sweep_part_way() {
  Progress progress;
  for (Row& row : rows_) visit(row, progress);
  const double left_m = progress.largest_m / part_;
  if (left_m < nearest_m_) {
    nearest_m_ = left_m;
    keep();
  }
  return left_m;
}

void ForceSweeps::keep() {
  displacement_before_ = displacement_;
  for (Row& row : rows_) row.force_before = row.force;
}

double ForceSweeps::take_nearest() {
  if (part_ == 1 || !(nearest_m_ < last_m_)) return last_m_;
  displacement_ = displacement_before_;
  for (Row& row : rows_) row.force = row.force_before;
  return nearest_m_;
}

double ForceSweeps::residual() const {
  double largest = 0;
  for (const Row& row : rows_) {
    const Eigen::Vector2d without = apart(row) - row.flexibility * row.force;
    const PointForces::Found found = row.forces.at(without[0], without[1]);
    const Eigen::Vector2d change = Eigen::Vector2d(found.normal, found.shear) - row.force;
    largest = std::max(largest, (row.flexibility * change).cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace blockweir::solid
