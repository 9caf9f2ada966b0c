// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/force_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::solid {
namespace {

constexpr int patience = 50;    // sweeps that come no nearer
constexpr double nearer = 0.9;  // than the nearest so far

}  // namespace

void ForceSweeps::begin(const Eigen::VectorXd& displacement, std::size_t rows, bool accelerates) {
  accelerates_ = accelerates;
  rows_are_new_ = true;
  rows_.clear();
  rows_.reserve(rows);
  entries_.clear();
  displacement_.setZero(displacement.size() + most_unknowns);
  displacement_.head(displacement.size()) = displacement;
}

void ForceSweeps::add_room(bool second, Eigen::Index first, Eigen::Index count) {
  rows_.back().ends[second ? 1 : 0] = {entries_.size(), static_cast<int>(first), static_cast<int>(count)};
  entries_.resize(entries_.size() + at(4 * count));
}

void ForceSweeps::begin_sweeps() {
  if (rows_are_new_) batches_.choose(rows_, entries_, displacement().size());
  rows_are_new_ = false;
  batches_.begin(rows_);
  alone_.clear();
  for (const int k : batches_.left_alone()) {
    Row& row = rows_[at(k)];
    alone_.emplace_back(law_of(row.rule, row.flexibility));
    row.force_before = row.force;
  }
  displacement_before_ = displacement_;
  momentum_ = 1;
  last_m_ = nearest_m_ = milestone_m_ = least_m_ = std::numeric_limits<double>::infinity();
  in_vain_ = 0;
  part_ = 1;
}

void ForceSweeps::displace(const Eigen::VectorXd& displacement) {
  displacement_.head(displacement.size()) = displacement;
  begin_sweeps();
}

void ForceSweeps::apply_forces() {
  for (const Row& row : rows_) act(row, row.force);
  begin_sweeps();
}

ForceSweeps::Entries ForceSweeps::motions(const Row::End& end) const {
  return {entries_.data() + end.first_entry, end.count, 2};
}

ForceSweeps::Entries ForceSweeps::responses(const Row::End& end) const {
  return {entries_.data() + end.first_entry + 2 * end.count, end.count, 2};
}

void ForceSweeps::act(const Row& row, const Eigen::Vector2d& force) {
  for (const Row::End& end : row.ends) {
    displacement_.segment(end.first, end.count).noalias() += responses(end) * force;
  }
}

Eigen::Vector2d ForceSweeps::apart(const Row& row) const {
  Eigen::Vector2d now = row.apart;
  for (const Row::End& end : row.ends) {
    now.noalias() += motions(end).transpose() * displacement_.segment(end.first, end.count);
  }
  return now;
}

void ForceSweeps::visit(std::size_t alone, SweepProgress& progress) {
  Row& row = rows_[at(batches_.left_alone()[alone])];
  const Eigen::Matrix2d& W = row.flexibility;
  const Eigen::Vector2d without = apart(row) - W * row.force;
  const auto found = alone_[alone].at(without[0], without[1]);
  const Eigen::Vector2d more = part_ * (Eigen::Vector2d(found.normal, found.shear) - row.force);
  row.slips = found.slips;
  if (more.isZero(0)) return;
  row.force += more;
  act(row, more);
  const Eigen::Vector2d since = row.force - row.force_before;
  progress.ahead -= W(0, 0) * more[0] * since[0] + W(1, 1) * more[1] * since[1];
  progress.largest_m = std::max(progress.largest_m, (W * more).cwiseAbs().maxCoeff());
}

/// Displacements, and forces of rows that are alone, by so much of what the last sweep has changed.
void ForceSweeps::go_on(double beyond) {
  for (const int k : batches_.left_alone()) {
    Row& row = rows_[at(k)];
    const Eigen::Vector2d now = row.force;
    row.force += beyond * (now - row.force_before);
    row.force_before = now;
  }
  displacement_before_.swap(displacement_);
  displacement_ = displacement_before_ + beyond * (displacement_before_ - displacement_);
}

int ForceSweeps::settle(int most, double enough_m) {
  double before_m = std::numeric_limits<double>::infinity();  // acceleration turns: two sweeps are to be near
  int n = 0;
  for (bool ends = false; n < most && !ends; ++n) {
    const double left_m = sweep_once();
    ends = std::max(left_m, before_m) <= enough_m;
    before_m = left_m;
  }
  batches_.give_back(rows_);
  return n;
}

double ForceSweeps::sweep() {
  const double left_m = sweep_once();
  batches_.give_back(rows_);
  return left_m;
}

double ForceSweeps::sweep_once() {
  constexpr double part = 0.7;
  if (part_ == 1 && in_vain_ >= patience) {
    part_ = part;
    in_vain_ = 0;
    milestone_m_ = std::numeric_limits<double>::infinity();
  }
  last_m_ = part_ == 1 ? sweep_ahead() : sweep_part_way();
  ++in_vain_;
  if (last_m_ < nearer * milestone_m_) {
    milestone_m_ = last_m_;
    in_vain_ = 0;
  }
  if (part_ != 1 && last_m_ < nearest_m_) {
    nearest_m_ = last_m_;
    keep();
  }
  return last_m_;
}

/// Acceleration begins anew where it turns back (O'Donoghue and Candes 2015), or where forces begin to grow: friction
/// makes the problem unsymmetric.
double ForceSweeps::sweep_ahead() {
  constexpr double grows = 2;  // above the least since it began
  const double next = (1 + std::sqrt(1 + 4 * momentum_ * momentum_)) / 2;
  const double beyond = (momentum_ - 1) / next;
  go_on(beyond);
  if (accelerates_) momentum_ = next;
  SweepProgress progress;
  batches_.sweep(beyond, 1, displacement_.data(), progress);
  for (std::size_t k = 0; k < alone_.size(); ++k) visit(k, progress);
  least_m_ = std::min(least_m_, progress.largest_m);
  if (progress.ahead > 0 || progress.largest_m > grows * least_m_) {
    momentum_ = 1;
    least_m_ = progress.largest_m;
  }
  return progress.largest_m;
}

/// Where friction jams blocks, forces that go all of their way run in circles.
double ForceSweeps::sweep_part_way() {
  SweepProgress progress;
  batches_.sweep(0, part_, displacement_.data(), progress);
  for (std::size_t k = 0; k < alone_.size(); ++k) visit(k, progress);
  return progress.largest_m / part_;
}

void ForceSweeps::keep() {
  displacement_before_ = displacement_;
  batches_.keep();
  for (const int k : batches_.left_alone()) rows_[at(k)].force_before = rows_[at(k)].force;
}

double ForceSweeps::take_nearest() {
  if (part_ == 1 || !(nearest_m_ < last_m_)) return last_m_;
  displacement_ = displacement_before_;
  batches_.take_kept();
  batches_.give_back(rows_);
  for (const int k : batches_.left_alone()) rows_[at(k)].force = rows_[at(k)].force_before;
  return nearest_m_;
}

double ForceSweeps::residual() const {
  double largest = 0;
  for (const Row& row : rows_) {
    const Eigen::Vector2d without = apart(row) - row.flexibility * row.force;
    const Eigen::Vector2d change = forces_of(row.rule, row.flexibility, without).force - row.force;
    largest = std::max(largest, (row.flexibility * change).cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace blockweir::solid
