// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/least_push.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {

LeastPush::LeastPush(std::vector<Eigen::Vector3d> mass, std::vector<Overlap> overlaps)
    : mass_(std::move(mass)),
      overlaps_(std::move(overlaps)),
      moved_(mass_.size(), Eigen::Vector3d::Zero()),
      place_(mass_.size(), -1) {
  constexpr double stiff = 1e7;  // against the bodies' inertia
  std::erase_if(overlaps_, [](const Overlap& o) { return o.ends[0].body < 0 && o.ends[1].body < 0; });
  for (const Overlap& o : overlaps_) {
    double flexibility = 0;
    for (const Overlap::End& end : o.ends) {
      if (end.body >= 0) flexibility += end.opens.dot(end.opens.cwiseQuotient(mass_[at(end.body)]));
    }
    stiffness_.push_back(stiff / flexibility);
  }
}

double LeastPush::opened(const Overlap& o, const Displacements& by) const {
  double opened = 0;
  for (const Overlap::End& end : o.ends) {
    if (end.body >= 0) opened += end.opens.dot(by[at(end.body)]);
  }
  return opened;
}

double LeastPush::gap(std::size_t overlap) const {
  return overlaps_[overlap].gap + opened(overlaps_[overlap], moved_);
}

double LeastPush::deepest() const {
  double deepest = 0;
  for (std::size_t i = 0; i < overlaps_.size(); ++i) deepest = std::max(deepest, -gap(i));
  return deepest;
}

void LeastPush::solve(double tolerance_m) {
  constexpr int most_solutions = 20;
  for (int solution = 0; solution < most_solutions; ++solution) {
    const Displacements way = towards_equilibrium();
    const double fraction = fraction_of(way);
    for (std::size_t b = 0; b < moved_.size(); ++b) moved_[b] += fraction * way[b];
    if (deepest() <= tolerance_m) return;
  }
}

/// To where springs that are pressed now balance the bodies' inertia; what no spring has pushed stays.
LeastPush::Displacements LeastPush::towards_equilibrium() {
  std::vector<std::size_t> pressed;
  std::vector<int> bodies;
  for (std::size_t i = 0; i < overlaps_.size(); ++i) {
    if (gap(i) >= 0) continue;
    pressed.push_back(i);
    for (const Overlap::End& end : overlaps_[i].ends) {
      if (end.body >= 0) bodies.push_back(end.body);
    }
  }
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    place_[at(bodies[k])] = static_cast<int>(3 * k);
    for (int i = 0; i < 3; ++i) entries.emplace_back(3 * k + at(i), 3 * k + at(i), mass_[at(bodies[k])][i]);
  }
  const auto unknowns = static_cast<Eigen::Index>(3 * bodies.size());
  Eigen::VectorXd force = Eigen::VectorXd::Zero(unknowns);
  for (const std::size_t i : pressed) {
    const Overlap& o = overlaps_[i];
    for (const Overlap::End& row : o.ends) {
      if (row.body < 0) continue;
      const int r = place_[at(row.body)];
      force.segment<3>(r) -= stiffness_[i] * o.gap * row.opens;
      for (const Overlap::End& column : o.ends) {
        if (column.body < 0) continue;
        const Eigen::Matrix3d k = stiffness_[i] * row.opens * column.opens.transpose();
        for (int m = 0; m < 3; ++m) {
          for (int n = 0; n < 3; ++n) entries.emplace_back(r + m, place_[at(column.body)] + n, k(m, n));
        }
      }
    }
  }
  Eigen::SparseMatrix<double> K(unknowns, unknowns);
  K.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd d = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>(K).solve(force);
  Displacements way(moved_.size());
  for (std::size_t b = 0; b < way.size(); ++b) {
    way[b] = (place_[b] < 0 ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(d.segment<3>(place_[b]))) -
             moved_[b];
    place_[b] = -1;
  }
  return way;
}

/// All of the way, or as much of it as leads to the least energy: its slope rises piecewise linearly.
double LeastPush::fraction_of(const Displacements& way) const {
  constexpr int most = 20;
  const auto slope = [&](double fraction) {
    double sum = 0;
    for (std::size_t b = 0; b < way.size(); ++b) {
      sum += way[b].dot(mass_[b].cwiseProduct(moved_[b] + fraction * way[b]));
    }
    for (std::size_t i = 0; i < overlaps_.size(); ++i) {
      const double along = opened(overlaps_[i], way);
      const double there = gap(i) + fraction * along;
      if (there < 0) sum += stiffness_[i] * there * along;
    }
    return sum;
  };
  double low = 0;
  double high = 1;
  double at_low = slope(0);
  double at_high = slope(1);
  if (at_high <= 1e-6 * std::abs(at_low)) return 1;
  for (int k = 0; k < most; ++k) {
    const double share = k % 2 == 0 ? at_low / (at_low - at_high) : 0.5;
    const double middle = low + share * (high - low);
    const double here = slope(middle);
    if (std::abs(here) <= 0.1 * std::abs(at_low)) return middle;
    (here < 0 ? low : high) = middle;
    (here < 0 ? at_low : at_high) = here;
  }
  return low;
}

}  // namespace blockweir::solid
