// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/cone_forces.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

constexpr double most_lost = 0.99;  // of a force or a motion in one correction

/// Of blocks that rows join, each pair once.
std::vector<std::pair<int, int>> couples_of(const std::vector<ForceRow>& rows, const std::vector<int>& block_of) {
  std::vector<std::pair<int, int>> couples;
  for (const ForceRow& row : rows) {
    const auto& [i, j] = row.ends;
    if (i.count > 0 && j.count > 0) couples.emplace_back(std::minmax(block_of[at(i.first)], block_of[at(j.first)]));
  }
  std::sort(couples.begin(), couples.end());
  couples.erase(std::unique(couples.begin(), couples.end()), couples.end());
  return couples;
}

std::vector<int> blocks_of(const Unknowns& unknowns) {
  std::vector<int> block_of(at(unknowns.total), -1);
  for (int k = 0; k < unknowns.blocks(); ++k) block_of[at(unknowns.first[at(k)])] = k;
  return block_of;
}

}  // namespace

ConeForces::ConeForces(const ForceSweeps& sweeps, const Unknowns& unknowns, const std::vector<Matrix6>& matrix)
    : sweeps_(sweeps),
      unknowns_(unknowns),
      matrix_(matrix),
      block_of_(blocks_of(unknowns)),
      system_(make_linear_system(unknowns, couples_of(sweeps.rows(), block_of_))) {
  system_->keep_pivots_on_diagonal();
}

void ConeForces::begin(const Eigen::VectorXd& loads) {
  loads_ = loads;
  load_ = loads.cwiseAbs().maxCoeff();
  displacement_ = own_motion(loads);
  ComplementaryPair far;
  far.force = load_;
  far.motion = displacement_.cwiseAbs().maxCoeff();
  pairs_.assign(sweeps_.rows().size(), {far, far});
  slips_.assign(sweeps_.rows().size(), {});
  opens_ = true;
  change_.setZero(loads.size());
  fraction_ = 1;
  solutions_ = 0;
  balance();
}

void ConeForces::let_slip(double smooth_m) {
  opens_ = false;
  for (std::size_t row = 0; row < slips_.size(); ++row) {
    const double slip = (sweeps_.rows()[row].apart + gained(row, displacement_)).y();
    const double size = std::hypot(slip, smooth_m);
    slips_[row] = {size, slip / size};
  }
}

bool ConeForces::improve() {
  constexpr double centre = 0.3;  // aimed at after a correction that was cut short
  constexpr double stuck = 0.15;  // of a change: what slips either way is to come away from its edges first
  const bool is_stuck = !opens_ && fraction_ < stuck;
  const double now = mean_product();
  if (!factorize() || !correct(0)) return false;
  const double share = std::max(0.0, mean_product(positive_fraction(1))) / now;
  const double aim = std::max(share * share * share, fraction_ > 0.5 ? 0 : is_stuck ? 1 : centre) * now;
  const double reached = is_stuck ? 0 : positive_fraction(1);
  for (Pairs& both : pairs_) {
    for (ComplementaryPair& p : both) p.product_change = reached * reached * p.force_change * p.motion_change;
  }
  if (!correct(aim)) return false;
  follow();
  balance();
  return true;
}

Eigen::Vector2d ConeForces::force(std::size_t row) const {
  const auto& [minus, plus] = pairs_[row];
  return {minus.force + plus.force, friction(row) * (plus.force - minus.force)};
}

double ConeForces::unbalanced() const {
  return load_ > 0 ? unbalanced_.cwiseAbs().maxCoeff() / load_ : 0;
}

double ConeForces::off_laws_m() const {
  Eigen::VectorXd forces = loads_;
  for (std::size_t row = 0; row < pairs_.size(); ++row) add_forces(row, force(row), forces);
  const Eigen::VectorXd moved = own_motion(forces);
  double largest = 0;
  for (std::size_t row = 0; row < pairs_.size(); ++row) {
    const ForceRow& r = sweeps_.rows()[row];
    const Eigen::Vector2d without = r.apart + gained(row, moved) - r.flexibility * force(row);
    const Eigen::Vector2d change = forces_of(r.rule, r.flexibility, without).force - force(row);
    largest = std::max(largest, (r.flexibility * change).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// Of blocks that nothing joins.
Eigen::VectorXd ConeForces::own_motion(const Eigen::VectorXd& forces) const {
  Eigen::VectorXd moved(forces.size());
  for (std::size_t k = 0; k < matrix_.size(); ++k) {
    const int n = unknowns_.count[k];
    const auto own = matrix_[k].topLeftCorner(n, n);
    moved.segment(unknowns_.first[k], n) = own.llt().solve(forces.segment(unknowns_.first[k], n));
  }
  return moved;
}

/// Gap and slip.
Eigen::Vector2d ConeForces::gained(std::size_t row, const Eigen::VectorXd& displacement) const {
  Eigen::Vector2d gains = Eigen::Vector2d::Zero();
  for (const ForceRow::End& end : sweeps_.rows()[row].ends) {
    gains.noalias() += sweeps_.motions(end).transpose() * displacement.segment(end.first, end.count);
  }
  return gains;
}

/// Gap by which a row is open, less what its slip either way opens by.
std::array<double, 2> ConeForces::motions(std::size_t row) const {
  const Eigen::Vector2d apart = sweeps_.rows()[row].apart + gained(row, displacement_);
  const double gap = apart.x() + friction(row) * slips_[row].size_m;
  const double opens = friction(row) * apart.y();
  return {gap - opens, gap + opens};
}

void ConeForces::add_forces(std::size_t row, const Eigen::Vector2d& force, Eigen::VectorXd& to) const {
  for (const ForceRow::End& end : sweeps_.rows()[row].ends) {
    to.segment(end.first, end.count).noalias() += sweeps_.motions(end) * force;
  }
}

void ConeForces::balance() {
  unbalanced_ = loads_;
  for (std::size_t k = 0; k < matrix_.size(); ++k) {
    const int n = unknowns_.count[k];
    const int first = unknowns_.first[k];
    unbalanced_.segment(first, n).noalias() -= matrix_[k].topLeftCorner(n, n) * displacement_.segment(first, n);
  }
  for (std::size_t row = 0; row < pairs_.size(); ++row) add_forces(row, force(row), unbalanced_);
}

/// Blocks' own matrices, and of each row the stiffnesses of its pairs along the edges of the cone.
bool ConeForces::factorize() {
  system_->set_zero();
  for (int k = 0; k < unknowns_.blocks(); ++k) system_->add(k, k, matrix_[at(k)]);
  Matrix6 block = Matrix6::Zero();
  for (std::size_t row = 0; row < pairs_.size(); ++row) {
    const ForceRow& r = sweeps_.rows()[row];
    const auto& [minus, plus] = pairs_[row];
    const double a = minus.stiffness();
    const double b = plus.stiffness();
    const double f = r.rule.friction;
    const double t = slips_[row].slope;
    Eigen::Matrix2d stiffness;
    stiffness << a + b, f * (b - a + t * (a + b)), f * (b - a), f * f * (a + b + t * (b - a));
    for (const ForceRow::End& i : r.ends) {
      for (const ForceRow::End& j : r.ends) {
        if (i.count == 0 || j.count == 0) continue;
        block.topLeftCorner(i.count, j.count).noalias() =
            sweeps_.motions(i) * (stiffness * sweeps_.motions(j).transpose());
        system_->add(block_of_[at(i.first)], block_of_[at(j.first)], block);
      }
    }
  }
  system_->forget_factors();
  ++solutions_;
  return system_->solve(/*symmetric=*/opens_, unbalanced_, change_);
}

/// Changes of all, by Newton's method on the balance and on products that are to be this, less their nonlinear part.
bool ConeForces::correct(double product) {
  Eigen::VectorXd right = unbalanced_;
  for (std::size_t row = 0; row < pairs_.size(); ++row) {
    const std::array<double, 2> now = motions(row);
    std::array<double, 2> more{};
    for (const std::size_t k : {0U, 1U}) {
      const ComplementaryPair& p = pairs_[row][k];
      more[k] = p.stiffness() * (p.lacks(product) - (now[k] - p.motion));
    }
    add_forces(row, {more[0] + more[1], friction(row) * (more[1] - more[0])}, right);
  }
  change_ = system_->solve_again(right);
  if (!change_.allFinite()) return false;
  for (std::size_t row = 0; row < pairs_.size(); ++row) {
    const std::array<double, 2> now = motions(row);
    const Eigen::Vector2d gains = gained(row, change_);
    const double slip = friction(row) * gains.y();
    const double taken_back = slips_[row].slope * slip;
    const std::array<double, 2> then{now[0] + gains.x() + taken_back - slip, now[1] + gains.x() + taken_back + slip};
    for (const std::size_t k : {0U, 1U}) {
      ComplementaryPair& p = pairs_[row][k];
      p.motion_change = then[k] - p.motion;
      p.force_change = p.stiffness() * (p.lacks(product) - p.motion_change);
    }
  }
  return true;
}

/// The part of all changes, at most one, that uses so much of the distance to zero.
double ConeForces::positive_fraction(double within) const {
  double fraction = 1;
  for (const Pairs& both : pairs_) {
    for (const ComplementaryPair& p : both) {
      fraction = std::min(fraction, p.positive_fraction(within));
    }
  }
  return fraction;
}

double ConeForces::mean_product(double fraction) const {
  double sum = 0;
  for (const Pairs& both : pairs_) {
    for (const ComplementaryPair& p : both) {
      sum += p.product_after(fraction);
    }
  }
  return sum / static_cast<double>(2 * pairs_.size());
}

void ConeForces::follow() {
  fraction_ = positive_fraction(most_lost);
  displacement_ += fraction_ * change_;
  for (Pairs& both : pairs_) {
    for (ComplementaryPair& p : both) {
      p.force += fraction_ * p.force_change;
      p.motion += fraction_ * p.motion_change;
      p.product_change = 0;
    }
  }
}

}  // namespace blockweir::solid
