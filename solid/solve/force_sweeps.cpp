// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/force_sweeps.hpp"

#include <algorithm>

namespace blockweir::solid {

void ForceSweeps::begin(const Eigen::VectorXd& displacement) {
  rows_.clear();
  entries_.clear();
  displacement_ = displacement;
}

void ForceSweeps::add_end(bool second, Eigen::Index first, const Eigen::Matrix2Xd& motions,
                          const Eigen::MatrixX2d& responses) {
  Row& row = rows_.back();
  row.ends[second ? 1 : 0] = {first, motions.cols(), entries_.size()};
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    for (Eigen::Index i = 0; i < motions.cols(); ++i) entries_.push_back(motions(axis, i));
  }
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    for (Eigen::Index i = 0; i < motions.cols(); ++i) entries_.push_back(responses(i, axis));
  }
  row.flexibility += motions * responses;
}

void ForceSweeps::let_act() {
  for (const Row& row : rows_) act(row, row.force);
}

void ForceSweeps::act(const Row& row, const Eigen::Vector2d& force) {
  for (const End& end : row.ends) {
    const double* by_normal = entries_.data() + end.first_entry + 2 * end.count;
    const double* by_shear = by_normal + end.count;
    double* moved = displacement_.data() + end.first;
    for (Eigen::Index i = 0; i < end.count; ++i) moved[i] += force[0] * by_normal[i] + force[1] * by_shear[i];
  }
}

Eigen::Vector2d ForceSweeps::apart(const Row& row) const {
  double gap = row.apart[0];
  double slip = row.apart[1];
  for (const End& end : row.ends) {
    const double* of_gap = entries_.data() + end.first_entry;
    const double* of_slip = of_gap + end.count;
    const double* moved = displacement_.data() + end.first;
    for (Eigen::Index i = 0; i < end.count; ++i) {
      gap += of_gap[i] * moved[i];
      slip += of_slip[i] * moved[i];
    }
  }
  return {gap, slip};
}

double ForceSweeps::sweep(double share) {
  double largest = 0;
  for (Row& row : rows_) {
    const Eigen::Vector2d without = apart(row) - row.flexibility * row.force;
    const RuledForce now = forces_of(row.rule, row.flexibility, without);
    const Eigen::Vector2d change = share * (now.force - row.force);
    row.slips = now.slips;
    if (change.isZero(0)) continue;
    row.force = share == 1 ? now.force : Eigen::Vector2d(row.force + change);
    act(row, change);
    largest = std::max(largest, (row.flexibility * change).cwiseAbs().maxCoeff());
  }
  return largest;
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
