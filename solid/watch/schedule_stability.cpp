// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/schedule_stability.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>

#include "bridge/geometry/polygon.hpp"
#include "bridge/scene/block_facts.hpp"
#include "solid/watch/dominant_eigenvalue.hpp"

namespace blockweir::solid {
namespace {

/// What a window starts from.
struct WindowStart {
  double x = 0;
  double v = 0;
  double a = 0;
  double told = 0;                   ///< velocity, at the last exchange
  std::array<double, 3> force{};     ///< of the water at the last exchanges, the last first
  std::array<double, 3> answered{};  ///< acceleration that it answers
};
constexpr int size = sizeof(WindowStart) / sizeof(double);

/// Lagrange's factors `ahead` windows after the last exchange.
std::array<double, 3> weights(scene::LoadInWindow load, double ahead) {
  if (load == scene::LoadInWindow::held) return {1, 0, 0};
  if (load == scene::LoadInWindow::linear) return {1 + ahead, -ahead, 0};
  return {(1 + ahead) * (2 + ahead) / 2, -ahead * (2 + ahead), ahead * (1 + ahead) / 2};
}

/// The water answers where the block of `from` will be `ahead_s` later.
void exchange(const Oscillator& o, const WindowStart& from, double ahead_s, WindowStart& s) {
  const double x = from.x + ahead_s * from.v + ahead_s * ahead_s / 2 * from.a;
  const double v = from.v + ahead_s * from.a;
  s.force = {0, s.force[0], s.force[1]};
  s.answered = {(v - s.told) / o.window_s, s.answered[0], s.answered[1]};
  s.force[0] = -o.added_mass * s.answered[0] - o.added_stiffness * x;
  s.told = v;
}

void step(const Oscillator& o, double ahead, WindowStart& s) {
  const double h = o.window_s;
  const auto w = weights(o.load, ahead);
  double force = 0;
  for (std::size_t i = 0; i < w.size(); ++i) force += w[i] * (s.force[i] + o.guarded_mass * s.answered[i]);
  const bool shi = o.integrator == scene::Integrator::shi;
  const double beta = shi ? 0.5 : 0.25;
  const double gamma = shi ? 1 : 0.5;
  const double x = s.x + h * s.v + h * h * (0.5 - beta) * s.a;
  const double a = (force - o.stiffness * x) / (o.mass + o.guarded_mass + o.stiffness * beta * h * h);
  s.x = x + beta * h * h * a;
  s.v += h * ((1 - gamma) * s.a + gamma * a);
  s.a = a;
}

WindowStart window(const Oscillator& o, WindowStart s) {
  const WindowStart before = s;
  switch (o.schedule) {
    case scene::Schedule::serial:
      exchange(o, before, 0, s);
      step(o, 1, s);
      break;
    case scene::Schedule::parallel:
      step(o, 1, s);
      exchange(o, before, o.window_s, s);
      break;
    case scene::Schedule::improved:
      exchange(o, before, o.window_s / 2, s);
      step(o, 0.5, s);
      break;
  }
  return s;
}

}  // namespace

Oscillator oscillator_of(const scene::Scene& scene, const std::string& block) {
  constexpr double gravity = scene::Column::gravity_m_per_s2;
  const scene::Column& c = scene.column;
  const scene::Block& b = block_named(scene, block);
  if (scene.fluid != scene::FluidModel::column || c.cushion_pa_per_m ||
      scene.coupling.window_s > scene.analysis.step_s ||
      scene.analysis.integrator == scene::Integrator::generalized_alpha) {
    throw std::runtime_error(
        "schedule-stability is known for a column without a cushion, a step a window, and Shi's or the trapezoidal "
        "rule");
  }
  const auto edge = static_cast<std::size_t>(c.edge);
  const double width = (b.vertices[(edge + 1) % b.vertices.size()] - b.vertices[edge]).norm();
  Oscillator o;
  o.mass = geometry::signed_area(b.vertices) * material_of(scene, b).density_kg_per_m3;
  for (const scene::Bolt& bolt : scene.bolts) o.stiffness += bolt.stiffness_n_per_m2;
  o.added_mass = scene.water.density_kg_per_m3 * c.length_m * width;
  o.added_stiffness = scene.water.density_kg_per_m3 * gravity * c.rise_ratio * width;
  o.guarded_mass = scene.coupling.added_mass_guard ? o.added_mass : 0;
  o.window_s = scene.coupling.window_s;
  o.integrator = scene.analysis.integrator;
  o.schedule = scene.coupling.schedule;
  o.load = scene.coupling.load_in_window;
  return o;
}

double largest_stable_ratio(const scene::Scene& scene) {
  constexpr double round_off = 1e-6;  // a free block's double root at 1 has half the digits
  Oscillator o{.mass = 1,
               .window_s = 1,
               .integrator = scene.analysis.integrator,
               .schedule = scene.coupling.schedule,
               .load = scene.coupling.load_in_window};
  double stable = 0;
  double unstable = 2;
  while (stable < 1 && unstable - stable > 1e-4) {
    o.added_mass = (stable + unstable) / 2;
    (schedule_growth(o) > 1 + round_off ? unstable : stable) = o.added_mass;
  }
  return std::min(stable, 1.0);
}

double schedule_growth(const Oscillator& o) {
  Eigen::Matrix<double, size, size> map;
  for (int i = 0; i < size; ++i) {
    std::array<double, size> unit{};
    unit[static_cast<std::size_t>(i)] = 1;
    const auto after = std::bit_cast<std::array<double, size>>(window(o, std::bit_cast<WindowStart>(unit)));
    map.col(i) = Eigen::Map<const Eigen::Vector<double, size>>(after.data());
  }
  return std::abs(dominant_eigenvalue(map));
}

}  // namespace blockweir::solid
