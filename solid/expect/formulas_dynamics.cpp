// SPDX-License-Identifier: GPL-3.0-or-later
// Oscillation and impact on a contact, rocking, waves in a bar, turning stress.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "bridge/geometry/outline.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/at.hpp"
#include "solid/expect/formula_tables.hpp"
#include "solid/step/newmark.hpp"
#include "solid/watch/dominant_eigenvalue.hpp"
#include "solid/watch/schedule_stability.hpp"

namespace blockweir::solid::expect {
namespace {

/// omega of a block that stands with two corners on springs of the contact's stiffness.
double contact_frequency(const Scene& s, const std::string& subject) {
  const scene::Block& b = block_named(s, subject);
  if (!s.contact.stiffness_n_per_m2)
    throw std::runtime_error(
        "[contact] states no stiffness_n_per_m2; expected formulation = \"penalty\" with one; state it");
  const double mass = geometry::signed_area(b.vertices) * material_of(s, b).density_kg_per_m3;
  return std::sqrt(2 * *s.contact.stiffness_n_per_m2 / mass);
}

/// Largest eigenvalue of the step's amplification matrix for (d, dt v, dt^2 a) of m a + k d = 0, Om = omega dt:
/// ((1 - am) + (1 - af) beta Om^2) A1 = -am A0 - Om^2 (D0 + (1 - af) (V0 + (1/2 - beta) A0)).
std::complex<double> contact_root(const Scene& s, const std::string& subject) {
  const Newmark n = Newmark::of(s.analysis.integrator, s.analysis.spectral_radius);
  const double omega2 = std::pow(contact_frequency(s, subject) * s.analysis.step_s, 2);
  const double f = 1 - n.alpha_f;
  const Eigen::RowVector3d a1 = Eigen::RowVector3d(-omega2, -omega2 * f, -n.alpha_m - omega2 * f * (0.5 - n.beta)) /
                                (1 - n.alpha_m + f * n.beta * omega2);
  Eigen::Matrix3d step;
  step.row(0) = Eigen::RowVector3d(1, 1, 0.5 - n.beta) + n.beta * a1;
  step.row(1) = Eigen::RowVector3d(0, 1, 1 - n.gamma) + n.gamma * a1;
  step.row(2) = a1;
  return dominant_eigenvalue(step);
}

/// Shi's scheme: 1/sqrt(1 + Om^2/2) up to Om = 4, where the roots turn real.
double contact_decay_per_step(const Scene& s, const std::string& subject) {
  return std::abs(contact_root(s, subject));
}

/// Shi's scheme: longer than 2 pi/omega by 11 Om^2/96 to first order.
double contact_period(const Scene& s, const std::string& subject) {
  return 2 * std::numbers::pi / std::abs(std::arg(contact_root(s, subject))) * s.analysis.step_s;
}

/// Shi's scheme: Om/4 to first order.
double contact_damping_ratio(const Scene& s, const std::string& subject) {
  constexpr double round_off = 1e-12;
  const std::complex<double> root = std::log(contact_root(s, subject));
  const double ratio = -root.real() / std::abs(root);
  return std::abs(ratio) < round_off ? 0 : ratio;
}

/// Shi's scheme in one unknown against a spring that only presses: y1 (1 + Om^2/2) = y0 + dt v0 while y1 < 0.
double contact_rebound_ratio(const Scene& s, const std::string& subject) {
  const scene::Block& b = block_named(s, subject);
  const double dt = s.analysis.step_s;
  const double omega2 = std::pow(contact_frequency(s, subject) * dt, 2);
  double gap = std::min_element(b.vertices.begin(), b.vertices.end(), [](const Point& p, const Point& q) {
                 return p.y() < q.y();
               })->y();
  const double before = b.initial_velocity_m_per_s.y();
  double velocity = before;
  for (double time = 0; time < s.analysis.duration_s; time += dt) {
    const double free = gap + dt * velocity;
    const double next = free < 0 ? free / (1 + omega2 / 2) : free;
    velocity = 2 * (next - gap) / dt - velocity;
    gap = next;
  }
  return -velocity / before;
}

/// Half-width, half-height and tilt of a rectangle.
struct Rocker {
  double half_width;
  double half_height;
  double tilt;  ///< rad

  [[nodiscard]] double radius() const { return std::hypot(half_width, half_height); }
  [[nodiscard]] double slenderness() const { return std::atan(half_width / half_height); }
};

Rocker rocker(const Scene& s, const std::string& subject) {
  const auto& v = block_named(s, subject).vertices;
  Point base = v[1] - v[0];
  Point side = v[2] - v[1];
  if (base.norm() > side.norm()) std::swap(base, side);
  return {base.norm() / 2, side.norm() / 2, std::abs(std::atan(base.y() / base.x()))};
}

/// Housner: 4 times the integral over th from 0 to th0 of dth/(p sqrt(2 (cos(al - th0) - cos(al - th)))),
/// p = sqrt(3 g/(4 R)); with th = th0 - s^2 the integrand is finite.
double rocking_period(const Scene& s, const std::string& subject) {
  constexpr int points = 100'000;
  const Rocker r = rocker(s, subject);
  const double p = std::sqrt(3 * s.analysis.gravity_m_per_s2 / (4 * r.radius()));
  const double ds = std::sqrt(r.tilt) / points;
  double quarter = 0;
  for (int i = 0; i < points; ++i) {
    const double root = (i + 0.5) * ds;
    const double fall = std::cos(r.slenderness() - r.tilt) - std::cos(r.slenderness() - r.tilt + root * root);
    quarter += 2 * root * ds / (p * std::sqrt(2 * fall));
  }
  return 4 * quarter;
}

/// Housner: 1 - 1.5 sin^2 al.
double rocking_impact_ratio(const Scene& s, const std::string& subject) {
  return 1 - 1.5 * std::pow(std::sin(rocker(s, subject).slenderness()), 2);
}

/// sqrt(E/rho), plane stress without lateral strain.
double bar_wave_speed(const Scene& s, const std::string& subject) {
  const scene::Material& m = material_of(s, block_named(s, subject));
  return std::sqrt(m.youngs_modulus_pa / m.density_kg_per_m3);
}

/// p/(rho c) behind the front that the first face pressure sends.
double bar_particle_speed(const Scene& s, const std::string& subject) {
  const scene::Material& m = material_of(s, block_named(s, subject));
  return s.face_pressures.at(0).pressure_from_pa.at(0) / (m.density_kg_per_m3 * bar_wave_speed(s, subject));
}

double bar_free_end_speed(const Scene& s, const std::string& subject) {
  return 2 * bar_particle_speed(s, subject);
}

/// Two masses on springs, the block and the water of its column: way of the block along the pipe at the run's end.
/// Without a cushion they are one. M x'' + K x = f from rest in the middle, but for the block's first velocity.
double column_displacement(const Scene& s, const std::string& subject) {
  constexpr double gravity = scene::Column::gravity_m_per_s2;
  const scene::Block& b = block_named(s, subject);
  const scene::Column& c = s.column;
  const auto edge = static_cast<std::size_t>(c.edge);
  const Point side = b.vertices[(edge + 1) % b.vertices.size()] - b.vertices[edge];
  const double width = side.norm();
  const Point into = Point(side.y(), -side.x()) / width;
  const double density = s.water.density_kg_per_m3;
  const double restoring = density * gravity * c.rise_ratio * width;
  const double cushion = c.cushion_pa_per_m.value_or(0) * width;
  double spring = 0;
  for (const scene::Bolt& bolt : s.bolts) spring += bolt.stiffness_n_per_m2;
  Eigen::Matrix2d M = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d K;
  M(0, 0) = geometry::signed_area(b.vertices) * material_of(s, b).density_kg_per_m3;
  M(1, 1) = density * c.length_m * width;
  K << spring + cushion, -cushion, -cushion, cushion + restoring;
  if (!c.cushion_pa_per_m) {
    M(0, 0) += M(1, 1);
    K(0, 0) += restoring;
    K(1, 1) = M(1, 1);  // a mode of its own that nothing drives
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> modes(K, M);
  const double t = s.analysis.duration_s;
  double way = 0;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d phi = modes.eigenvectors().col(i);
    const double omega = std::sqrt(modes.eigenvalues()[i]);
    const double push = -density * gravity * c.head_m * width * phi[0];
    const double speed = M(0, 0) * into.dot(b.initial_velocity_m_per_s) * phi[0];
    way += phi[0] * (push / (omega * omega) * (1 - std::cos(omega * t)) + speed / omega * std::sin(omega * t));
  }
  return std::abs(way);
}

/// 2 pi sqrt(M/K) of a block with the water of its column, without a cushion.
double column_period(const Scene& s, const std::string& subject) {
  const Oscillator o = oscillator_of(s, subject);
  return 2 * std::numbers::pi * std::sqrt((o.mass + o.added_mass) / (o.stiffness + o.added_stiffness));
}

/// Of an upright wall on its bolts, which are level, before a long reservoir with a level surface: 2 pi sqrt((m +
/// m_a)/k) with Westergaard's series m_a = rho H^2 sum 16/((2n-1) pi)^3.
double wall_in_reservoir_period(const Scene& s, const std::string& subject) {
  constexpr double long_reservoir = 0.5427545;
  const scene::Block& b = block_named(s, subject);
  const double depth = s.water.upstream_level_m->at(0) - geometry::bounds_of(b.vertices).low.y();
  double mass = 0;
  for (const scene::Block& block : s.blocks) {
    if (!block.fixed) mass += geometry::signed_area(block.vertices) * material_of(s, block).density_kg_per_m3;
  }
  double stiffness = 0;
  for (const scene::Bolt& bolt : s.bolts) stiffness += bolt.stiffness_n_per_m2;
  if (stiffness == 0)
    throw std::runtime_error("no [[bolt]] is on block \"" + subject + "\"; expected a spring that holds it; add one");
  return 2 * std::numbers::pi *
         std::sqrt((mass + long_reservoir * s.water.density_kg_per_m3 * depth * depth) / stiffness);
}

/// The initial stress turned with a block that keeps its spin.
Eigen::Matrix2d turned_stress(const Scene& s, const std::string& subject) {
  const scene::Block& b = block_named(s, subject);
  const Eigen::Vector3d own = b.initial_stress_pa.value_or(material_of(s, b).initial_stress_pa);
  Eigen::Matrix2d stress;
  stress << own[0], own[2], own[2], own[1];
  const Eigen::Rotation2Dd turn(b.initial_spin_deg_per_s * std::numbers::pi / 180 * s.analysis.duration_s);
  return turn * stress * turn.inverse();
}

double turned_stress_xx(const Scene& s, const std::string& subject) {
  return turned_stress(s, subject)(0, 0);
}
double turned_stress_yy(const Scene& s, const std::string& subject) {
  return turned_stress(s, subject)(1, 1);
}
double turned_stress_xy(const Scene& s, const std::string& subject) {
  return turned_stress(s, subject)(0, 1);
}

}  // namespace

const Formulas& dynamics_formulas() {
  static const Formulas all = {{"contact-decay-per-step", contact_decay_per_step},
                               {"contact-period", contact_period},
                               {"contact-damping-ratio", contact_damping_ratio},
                               {"contact-rebound-ratio", contact_rebound_ratio},
                               {"rocking-period", rocking_period},
                               {"rocking-impact-ratio", rocking_impact_ratio},
                               {"bar-wave-speed", bar_wave_speed},
                               {"bar-particle-speed", bar_particle_speed},
                               {"bar-free-end-speed", bar_free_end_speed},
                               {"column-displacement", column_displacement},
                               {"column-period", column_period},
                               {"wall-in-reservoir-period", wall_in_reservoir_period},
                               {"turned-stress-xx", turned_stress_xx},
                               {"turned-stress-yy", turned_stress_yy},
                               {"turned-stress-xy", turned_stress_xy}};
  return all;
}

}  // namespace blockweir::solid::expect
