// SPDX-License-Identifier: GPL-3.0-or-later
// Figures from the course of a block's motion: oscillation, rebound, rocking, waves.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <span>

#include "solid/expect/quantity_tables.hpp"
#include "solid/watch/dominant_eigenvalue.hpp"

namespace blockweir::solid::expect {
namespace {

const Course& course_of(const Outcome& o, const std::string& subject) {
  return o.series.of(block_index(o.solid, subject));
}

/// Of the displacements in x and y the one that swings more.
Eigen::VectorXd signal_of(std::span<const Sample> course) {
  Eigen::Matrix<double, Eigen::Dynamic, 2> u(static_cast<Eigen::Index>(course.size()), 2);
  for (std::size_t i = 0; i < course.size(); ++i) {
    u.row(static_cast<Eigen::Index>(i)) = course[i].displacement.head<2>().transpose();
  }
  const Eigen::RowVector2d range = u.colwise().maxCoeff() - u.colwise().minCoeff();
  return range[1] >= range[0] ? u.col(1) : u.col(0);
}

/// Samples at equal steps: without the last, where the run's end cuts the step.
std::span<const Sample> equally_spaced(const Course& course) {
  std::size_t n = course.size();
  const auto spacing = [&](std::size_t i) { return course[i].time_s - course[i - 1].time_s; };
  if (n > 2 && std::abs(spacing(n - 1) / spacing(1) - 1) > 1e-6) --n;
  return {course.data(), n};
}

/// The x with the least |Ax - b|. One function for both fits here: Eigen's decomposition takes seconds to compile.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.colPivHouseholderQr().solve(b);
}

/// The recurrence u_n = f_1 u_n-1 + ... + f_p u_n-p + c that fits the signal best (Prony's method).
struct Recurrence {
  Eigen::VectorXd factors;
  double misfit = 0;  ///< root mean square, over the signal's largest value

  Recurrence(const Eigen::VectorXd& u, Eigen::Index order) {
    const Eigen::Index n = u.size() - order;
    Eigen::MatrixXd past = Eigen::MatrixXd::Ones(n, order + 1);
    for (Eigen::Index k = 0; k < order; ++k) past.col(k) = u.segment(order - 1 - k, n);
    const Eigen::VectorXd fit = least_squares(past, u.tail(n));
    misfit = (past * fit - u.tail(n)).norm() / std::sqrt(static_cast<double>(n));
    factors = fit.head(order);
  }

  /// Its size is the decay a step, its angle the frequency.
  [[nodiscard]] std::complex<double> largest_root() const {
    const Eigen::Index order = factors.size();
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(order, order);
    companion.row(0) = factors.transpose();
    companion.diagonal(-1).setOnes();
    return dominant_eigenvalue(companion);
  }
};

/// Of the recurrence of lowest order that the signal follows: one oscillator under a one-step scheme follows one of
/// order two, or three where the scheme remembers accelerations.
std::complex<double> dominant_root(const Outcome& o, const std::string& subject) {
  constexpr double followed = 1e-9;
  constexpr double still = 1e-13;  // of the model: round-off
  const std::span<const Sample> course = equally_spaced(course_of(o, subject));
  if (course.size() < 8) throw NoFigure("no oscillation: the run has fewer than 8 steps");
  Eigen::VectorXd u = signal_of(course);
  if (u.maxCoeff() - u.minCoeff() <= still * o.solid.model().size_m)
    throw NoFigure("no oscillation: the block does not move");
  u.array() -= u.mean();
  u /= u.cwiseAbs().maxCoeff();
  const Recurrence two(u, 2);
  return two.misfit < followed ? two.largest_root() : Recurrence(u, 3).largest_root();
}

double step_of(const Outcome& o, const std::string& subject) {
  const std::span<const Sample> course = equally_spaced(course_of(o, subject));
  return (course.back().time_s - course.front().time_s) / static_cast<double>(course.size() - 1);
}

/// The same, of a run that holds a whole period of it.
std::complex<double> oscillation_root(const Outcome& o, const std::string& subject) {
  const std::complex<double> root = dominant_root(o, subject);
  const double angle = std::abs(std::arg(root));
  if (angle == 0) throw NoFigure("no oscillation: the motion dies out or grows without one");
  const double steps = static_cast<double>(equally_spaced(course_of(o, subject)).size() - 1);
  if (steps * angle < 2 * std::numbers::pi) throw NoFigure("no whole period: the run ends before it");
  return root;
}

double decay_per_step(const Outcome& o, const std::string& subject) {
  return std::abs(dominant_root(o, subject));
}

double oscillation_period(const Outcome& o, const std::string& subject) {
  return 2 * std::numbers::pi / std::abs(std::arg(oscillation_root(o, subject))) * step_of(o, subject);
}

double oscillation_damping(const Outcome& o, const std::string& subject) {
  const std::complex<double> s = std::log(oscillation_root(o, subject));
  return -s.real() / std::abs(s);
}

/// A stretch of the course over which a rate keeps its sign.
struct Swing {
  double fastest = 0;  ///< the largest |rate|
  double time_s = 0;   ///< of it
  double last = 0;     ///< |rate| at its end, or the run's

  /// Whether the rate has gone back by that share of its largest: what was to be the fastest is then past.
  [[nodiscard]] bool past(double share) const { return last <= (1 - share) * fastest; }
};

/// At an impact spin falls by 1.5 sin^2(slenderness), and after it on; noise of contacts is smaller.
constexpr double slower_after_impact = 0.01;

std::vector<Swing> swings(const Course& course, Eigen::Index unknown) {
  std::vector<Swing> all;
  double sign = 0;
  for (const Sample& s : course) {
    const double rate = s.velocity[unknown];
    if (rate == 0) continue;
    if (rate * sign <= 0) all.emplace_back();
    sign = rate;
    Swing& swing = all.back();
    swing.last = std::abs(rate);
    if (swing.last > swing.fastest) swing = {swing.last, s.time_s, swing.last};
  }
  return all;
}

/// Largest speed after the first return of the vertical velocity over the largest before; 0 for a block that comes to
/// rest without one.
double rebound_ratio(const Outcome& o, const std::string& subject) {
  constexpr double all_but_rest = 0.999;
  constexpr double settled = 1e-6;  // of the speed, by which the last step changes it
  const Course& course = course_of(o, subject);
  const auto all = swings(course, 1);
  if (all.empty() || (all.size() < 2 && !all[0].past(all_but_rest)))
    throw NoFigure("no rebound: the run ends before it");
  if (all.size() < 2) return 0;
  // Two samples say whether the contact still pushes the block away.
  const double rise = std::abs(course.back().velocity[1]) - std::abs(course[course.size() - 2].velocity[1]);
  const bool leaves = all.size() == 2 && rise > settled * all[1].fastest && all[1].last == all[1].fastest;
  if (leaves) throw NoFigure("no rebound: the run ends while the contact still pushes");
  return all[1].fastest / all[0].fastest;
}

/// Four times the time from release to the fastest spin, which is at the impact.
double rocking_period(const Outcome& o, const std::string& subject) {
  const auto all = swings(course_of(o, subject), 2);
  if (all.empty() || (all.size() < 2 && !all[0].past(slower_after_impact))) {
    throw NoFigure("no impact: the run ends before it");
  }
  return 4 * all[0].time_s;
}

/// Spin after over spin before the first impact: a swing back is as fast at its end, the second impact, as the first
/// left it.
double impact_ratio(const Outcome& o, const std::string& subject) {
  const auto all = swings(course_of(o, subject), 2);
  if (all.size() < 2 || (all.size() < 3 && !all[1].past(slower_after_impact))) {
    throw NoFigure("no second impact: the run ends before the block has swung back");
  }
  return all[1].fastest / all[0].fastest;
}

/// Mean speed of the centroid over the last tenth of the run.
double late_speed(const Outcome& o, const std::string& subject) {
  const Course& course = course_of(o, subject);
  double sum = 0;
  int count = 0;
  for (const Sample& s : course) {
    if (s.time_s < 0.9 * course.back().time_s) continue;
    sum += s.velocity.head<2>().norm();
    ++count;
  }
  return sum / count;
}

/// Distance from the first pressure's face to the block, over the time when the front passed it: where the straight
/// line of its late displacements meets zero, which ripples behind the front do not shift.
double wave_speed(const Outcome& o, const std::string& subject) {
  const auto& loads = o.solid.scene().face_pressures;
  if (loads.empty()) throw NoFigure("no wave: the scene has no [[face_pressure]]");
  const Point from = (loads.front().from_m + loads.front().to_m) / 2;
  const double distance = (o.solid.blocks()[block_index(o.solid, subject)].centroid - from).norm();
  const Course& course = course_of(o, subject);
  const auto late = static_cast<Eigen::Index>(course.size() / 4);
  if (late < 3) throw NoFigure("no front: the run has too few steps");
  Eigen::MatrixXd times(late, 2);
  Eigen::VectorXd moved(late);
  for (Eigen::Index i = 0; i < late; ++i) {
    const Sample& s = course[course.size() - static_cast<std::size_t>(late - i)];
    times.row(i) << 1, s.time_s;
    moved[i] = s.displacement.head<2>().norm();
  }
  const Eigen::Vector2d line = least_squares(times, moved);
  const double passed_s = -line[0] / line[1];
  constexpr double still = 1e-6;  // of what has moved farthest: round-off, ahead of the front
  if (!(passed_s > 0 && passed_s < times(0, 1)) || moved[late - 1] < still * o.last.largest_displacement_m)
    throw NoFigure("no front: the run ends before it has passed the block");
  return distance / passed_s;
}

/// Largest change of the moment of momentum about the centroid, over its first value.
double angular_momentum_error(const Outcome& o, const std::string& subject) {
  const Inertia& inertia = o.solid.blocks()[block_index(o.solid, subject)].inertia;
  const auto momentum = [&](const Sample& s) { return (inertia * s.velocity)[2]; };
  const Course& course = course_of(o, subject);
  const double first = momentum(course.front());
  if (first == 0) throw NoFigure("no angular momentum to keep: the block does not spin at first");
  double largest = 0;
  for (const Sample& s : course) largest = std::max(largest, std::abs(momentum(s) / first - 1));
  return largest;
}

}  // namespace

const Quantities& series_quantities() {
  static const Quantities all = {{"decay_per_step", decay_per_step},
                                 {"oscillation_period_s", oscillation_period},
                                 {"oscillation_damping_ratio", oscillation_damping},
                                 {"rebound_ratio", rebound_ratio},
                                 {"rocking_period_s", rocking_period},
                                 {"impact_ratio", impact_ratio},
                                 {"late_speed_m_per_s", late_speed},
                                 {"wave_speed_m_per_s", wave_speed},
                                 {"slip_over_balance", slip_over_balance},
                                 {"angular_momentum_error", angular_momentum_error}};
  return all;
}

}  // namespace blockweir::solid::expect
