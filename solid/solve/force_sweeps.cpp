// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/force_sweeps.hpp"

#include <algorithm>
#include <cmath>

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
  for (const Row& row : rows_) act(row, row.force[0], row.force[1]);
}

namespace {

/// Of rigid blocks, most of what is swept: no loop, and sums that do not wait for each other.
double dot3(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

void ForceSweeps::act(const Row& row, double normal, double shear) {
  for (const End& end : row.ends) {
    const double* by_normal = entries_.data() + end.first_entry + 2 * end.count;
    const double* by_shear = by_normal + end.count;
    double* moved = displacement_.data() + end.first;
    if (end.count == 3) {
      const std::array<double, 3> sum = {moved[0] + (normal * by_normal[0] + shear * by_shear[0]),
                                         moved[1] + (normal * by_normal[1] + shear * by_shear[1]),
                                         moved[2] + (normal * by_normal[2] + shear * by_shear[2])};
      std::copy(sum.begin(), sum.end(), moved);
      continue;
    }
    for (Eigen::Index i = 0; i < end.count; ++i) moved[i] += normal * by_normal[i] + shear * by_shear[i];
  }
}

Eigen::Vector2d ForceSweeps::apart(const Row& row) const {
  double gap = row.apart[0];
  double slip = row.apart[1];
  for (const End& end : row.ends) {
    const double* of_gap = entries_.data() + end.first_entry;
    const double* of_slip = of_gap + end.count;
    const double* moved = displacement_.data() + end.first;
    if (end.count == 3) {
      gap += dot3(of_gap, moved);
      slip += dot3(of_slip, moved);
      continue;
    }
    for (Eigen::Index i = 0; i < end.count; ++i) {
      gap += of_gap[i] * moved[i];
      slip += of_slip[i] * moved[i];
    }
  }
  return {gap, slip};
}

/// In scalars: a pair that has just been written one by one is read slowly as one.
double ForceSweeps::sweep(double share) {
  double largest = 0;
  for (Row& row : rows_) {
    const Eigen::Matrix2d& W = row.flexibility;
    const double normal = row.force[0];
    const double shear = row.force[1];
    const Eigen::Vector2d now = apart(row);
    const Eigen::Vector2d without(now[0] - W(0, 0) * normal - W(0, 1) * shear,
                                  now[1] - W(1, 0) * normal - W(1, 1) * shear);
    const RuledForce found = forces_of(row.rule, W, without);
    const double more_normal = share * (found.force[0] - normal);
    const double more_shear = share * (found.force[1] - shear);
    row.slips = found.slips;
    if (more_normal == 0 && more_shear == 0) continue;
    row.force[0] = share == 1 ? found.force[0] : normal + more_normal;
    row.force[1] = share == 1 ? found.force[1] : shear + more_shear;
    act(row, more_normal, more_shear);
    largest = std::max({largest, std::abs(W(0, 0) * more_normal + W(0, 1) * more_shear),
                        std::abs(W(1, 0) * more_normal + W(1, 1) * more_shear)});
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
