// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/solve/standing_forces.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

constexpr int most_solutions = 60;
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

StandingForces::StandingForces(const ForceSweeps& sweeps, const Unknowns& unknowns, const std::vector<Matrix6>& matrix)
    : sweeps_(sweeps),
      unknowns_(unknowns),
      matrix_(matrix),
      block_of_(blocks_of(unknowns)),
      system_(make_linear_system(unknowns, couples_of(sweeps.rows(), block_of_))) {}

bool StandingForces::found(const Eigen::VectorXd& loads, double enough_m) {
  constexpr double balanced = 1e-8;  // of the largest load
  constexpr double centre = 0.3;     // aimed at after a correction that was cut short
  constexpr double surely = 1e4;     // where forces are next to the edge of their cones products are as much less
  constexpr double exactly = 1e-3;   // of what is enough, where it costs only a solution or two
  begin(loads);
  const double load = loads.cwiseAbs().maxCoeff();
  double fraction = 1;
  for (solutions_ = 0; solutions_ < most_solutions;) {
    unbalanced_ = unbalanced(loads);
    const bool balances = unbalanced_.cwiseAbs().maxCoeff() <= balanced * load;
    if (balances && stands(load, exactly * enough_m)) return true;
    const double now = mean_product(0);
    // What is lost in slip is known to the sum of all products. Round-off spoils the balance of what slips.
    const double known = lost_in_slip() / (now * static_cast<double>(2 * pairs_.size()));
    if (known > surely && !stands(load, enough_m)) return false;
    if (known > surely && balances) return true;
    if (!factorize() || !correct(0)) return false;
    const double share = std::max(0.0, mean_product(positive_fraction(1))) / now;
    const double aim = std::max(share * share * share, fraction > 0.5 ? 0 : centre) * now;
    const double reached = positive_fraction(1);
    for (Pairs& both : pairs_) {
      for (ComplementaryPair& p : both) p.product_change = reached * reached * p.force_change * p.motion_change;
    }
    if (!correct(aim)) return false;
    fraction = positive_fraction(most_lost);
    follow(fraction);
  }
  return false;
}

Eigen::Vector2d StandingForces::force(std::size_t row) const {
  const auto& [minus, plus] = pairs_[row];
  return {minus.force + plus.force, sweeps_.rows()[row].rule.friction * (plus.force - minus.force)};
}

/// Far from zero: forces of the largest load, motions of what it moves in the step.
void StandingForces::begin(const Eigen::VectorXd& loads) {
  displacement_.resize(loads.size());
  for (std::size_t k = 0; k < matrix_.size(); ++k) {
    const int n = unknowns_.count[k];
    const auto own = matrix_[k].topLeftCorner(n, n);
    displacement_.segment(unknowns_.first[k], n) = own.llt().solve(loads.segment(unknowns_.first[k], n));
  }
  ComplementaryPair far;
  far.force = loads.cwiseAbs().maxCoeff();
  far.motion = displacement_.cwiseAbs().maxCoeff();
  pairs_.assign(sweeps_.rows().size(), {far, far});
  change_.setZero(loads.size());
}

/// Gap by which a row is open, less what its slip either way opens by.
std::array<double, 2> StandingForces::motions(std::size_t row, const Eigen::VectorXd& displacement) const {
  const ForceRow& r = sweeps_.rows()[row];
  Eigen::Vector2d apart = r.apart;
  for (const ForceRow::End& end : r.ends) {
    apart.noalias() += sweeps_.motions(end).transpose() * displacement.segment(end.first, end.count);
  }
  const double opens = r.rule.friction * apart.y();
  return {apart.x() - opens, apart.x() + opens};
}

void StandingForces::add_forces(std::size_t row, const Eigen::Vector2d& force, Eigen::VectorXd& to) const {
  for (const ForceRow::End& end : sweeps_.rows()[row].ends) {
    to.segment(end.first, end.count).noalias() += sweeps_.motions(end) * force;
  }
}

Eigen::VectorXd StandingForces::unbalanced(const Eigen::VectorXd& loads) const {
  Eigen::VectorXd left = loads;
  for (std::size_t k = 0; k < matrix_.size(); ++k) {
    const int n = unknowns_.count[k];
    const int first = unknowns_.first[k];
    left.segment(first, n).noalias() -= matrix_[k].topLeftCorner(n, n) * displacement_.segment(first, n);
  }
  for (std::size_t row = 0; row < pairs_.size(); ++row) add_forces(row, force(row), left);
  return left;
}

/// What bears next to nothing may slip, as what is open does, and what has no friction.
bool StandingForces::stands(double load, double enough_m) const {
  constexpr double nothing = 1e-6;
  for (std::size_t row = 0; row < pairs_.size(); ++row) {
    const auto& [minus, plus] = pairs_[row];
    const bool slips = std::abs(plus.motion - minus.motion) > 2 * enough_m * sweeps_.rows()[row].rule.friction;
    if (slips && minus.force + plus.force > nothing * load) return false;
  }
  return true;
}

double StandingForces::lost_in_slip() const {
  double lost = 0;
  for (const auto& [minus, plus] : pairs_) {
    lost += (minus.force + plus.force) * std::abs(plus.motion - minus.motion) / 2;
  }
  return lost;
}

/// Blocks' own matrices, and of each row the stiffnesses of its pairs along the edges of the cone.
bool StandingForces::factorize() {
  system_->set_zero();
  for (int k = 0; k < unknowns_.blocks(); ++k) system_->add(k, k, matrix_[at(k)]);
  Matrix6 block = Matrix6::Zero();
  for (std::size_t row = 0; row < pairs_.size(); ++row) {
    const ForceRow& r = sweeps_.rows()[row];
    const auto& [minus, plus] = pairs_[row];
    const double a = minus.stiffness();
    const double b = plus.stiffness();
    const double f = r.rule.friction;
    Eigen::Matrix2d stiffness;
    stiffness << a + b, f * (b - a), f * (b - a), f * f * (a + b);
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
  return system_->solve(/*symmetric=*/true, unbalanced_, change_);
}

/// Changes of all, by Newton's method on the balance and on products that are to be this, less their nonlinear part.
bool StandingForces::correct(double product) {
  Eigen::VectorXd right = unbalanced_;
  for (std::size_t row = 0; row < pairs_.size(); ++row) {
    const std::array<double, 2> now = motions(row, displacement_);
    std::array<double, 2> more{};
    for (const std::size_t k : {0U, 1U}) {
      const ComplementaryPair& p = pairs_[row][k];
      more[k] = p.stiffness() * (p.lacks(product) - (now[k] - p.motion));
    }
    const double friction = sweeps_.rows()[row].rule.friction;
    add_forces(row, {more[0] + more[1], friction * (more[1] - more[0])}, right);
  }
  change_ = system_->solve_again(right);
  if (!change_.allFinite()) return false;
  const Eigen::VectorXd there = displacement_ + change_;
  for (std::size_t row = 0; row < pairs_.size(); ++row) {
    const std::array<double, 2> then = motions(row, there);
    for (const std::size_t k : {0U, 1U}) {
      ComplementaryPair& p = pairs_[row][k];
      p.motion_change = then[k] - p.motion;
      p.force_change = p.stiffness() * (p.lacks(product) - p.motion_change);
    }
  }
  return true;
}

/// The part of all changes, at most one, that uses so much of the distance to zero.
double StandingForces::positive_fraction(double within) const {
  double fraction = 1;
  for (const Pairs& both : pairs_) {
    for (const ComplementaryPair& p : both) {
      fraction = std::min(fraction, p.positive_fraction(within));
    }
  }
  return fraction;
}

double StandingForces::mean_product(double fraction) const {
  double sum = 0;
  for (const Pairs& both : pairs_) {
    for (const ComplementaryPair& p : both) {
      sum += p.product_after(fraction);
    }
  }
  return sum / static_cast<double>(2 * pairs_.size());
}

void StandingForces::follow(double fraction) {
  displacement_ += fraction * change_;
  for (Pairs& both : pairs_) {
    for (ComplementaryPair& p : both) {
      p.force += fraction * p.force_change;
      p.motion += fraction * p.motion_change;
      p.product_change = 0;
    }
  }
}

}  // namespace blockweir::solid
