// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_watch bridge_checkpoint
// Ground that goes on below a column and beside it (Lysmer and Kuhlemeyer 1969): what leaves does not come back, and a
// base motion comes in.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/geometry/mesh.hpp"
#include "solid/step/solid.hpp"
#include "solid/watch/energy.hpp"

namespace blockweir::solid::viscous_boundary_test {
namespace {

constexpr double E = 5.2e9;
constexpr double nu = 0.3;
constexpr double density = 2000;
const double shear_speed = std::sqrt(E / (2 * (1 + nu)) / density);  // 1,000 m/s
const double pressure_speed = shear_speed * std::sqrt(2 * (1 - nu) / (1 - 2 * nu));
constexpr double height = 40;
constexpr double width = 2;

enum class Wave { shear, pressure };
constexpr int axis_of(Wave wave) {
  return wave == Wave::shear ? 0 : 1;
}
double speed_of(Wave wave) {
  return wave == Wave::shear ? shear_speed : pressure_speed;
}

/// A meshed column on a viscous face, as wide as it likes: its sides move with the wave alone.
scene::Scene column(Wave wave, double mesh_m, double step_s) {
  scene::Scene scene;
  scene.materials.push_back({"soil", E, nu, density});
  scene.analysis.gravity_m_per_s2 = 0;
  scene.analysis.start = scene::Start::unstressed;
  scene.analysis.integrator = scene::Integrator::trapezoidal;
  scene.analysis.step_s = step_s;
  scene.blocks.push_back(
      {.name = "ground", .vertices = {{0, 0}, {width, 0}, {width, height}, {0, height}}, .mesh_size_m = mesh_m});
  for (const Point& node : geometry::triangulate(scene.blocks[0].vertices, mesh_m).nodes) {
    if (node.x() > 0 && node.x() < width) continue;
    scene::Support guide{.block = 0, .point_m = node};
    (wave == Wave::shear ? guide.displacement_y_m : guide.displacement_x_m) = scene::TimeTable::constant(0);
    scene.supports.push_back(guide);
  }
  scene.viscous_faces.push_back({.block = 0, .from_m = {0, 0}, .to_m = {width, 0}});
  return scene;
}

/// (1 - cos)/2 in `length_s`, times `peak`.
scene::TimeTable pulse(double peak, double length_s) {
  scene::TimeTable table{{}, {}};
  constexpr int rows = 200;
  for (int i = 0; i <= rows; ++i) {
    table.time_s.push_back(length_s * i / rows);
    table.value.push_back(peak / 2 * (1 - std::cos(2 * std::numbers::pi * i / rows)));
  }
  return table;
}

/// Its rate.
scene::TimeTable rate_of_pulse(double peak, double length_s) {
  scene::TimeTable table{{}, {}};
  constexpr int rows = 200;
  for (int i = 0; i <= rows; ++i) {
    table.time_s.push_back(length_s * i / rows);
    table.value.push_back(peak * std::numbers::pi / length_s * std::sin(2 * std::numbers::pi * i / rows));
  }
  return table;
}

double velocity_at(const Solid& solid, int block, const Point& point, int axis) {
  const Anchor a = solid.parts().anchor(block, point);
  const auto part = static_cast<std::size_t>(a.part);
  return (solid.placements()[part].shape(a.material) * solid.velocity(part))[axis];
}

/// Largest velocity between two times, at a height of the column.
struct Peak {
  double y_m;
  double from_s;
  double to_s;
  double value = 0;
};

void run(Solid& solid, double duration_s, int axis, std::vector<Peak>& peaks, EnergyWatch* energy = nullptr) {
  const double dt = solid.scene().analysis.step_s;
  for (int n = 0; n < std::lround(duration_s / dt); ++n) {
    solid.advance(n * dt, (n + 1) * dt, {});
    if (energy != nullptr) energy->look(solid);
    for (Peak& p : peaks) {
      const double t = (n + 1) * dt;
      if (t < p.from_s || t > p.to_s) continue;
      const double v = velocity_at(solid, 0, {width / 2, p.y_m}, axis);
      if (std::abs(v) > std::abs(p.value)) p.value = v;
    }
  }
}

class ViscousBoundaryOf : public testing::TestWithParam<std::tuple<Wave, scene::Integrator>> {};

/// A push on the top, whose wave is 30 m long; 2 m of mesh, steps of 0.5 m. What the boundary reflects passes the
/// middle on its way up.
TEST_P(ViscousBoundaryOf, AWaveThatLeavesDoesNotComeBack) {
  const auto [wave, integrator] = GetParam();
  const int axis = axis_of(wave);
  const double c = speed_of(wave);
  const double length_s = 30 / c;
  auto scene = column(wave, 2, 0.5 / c);
  scene.analysis.integrator = integrator;
  scene::LineLoad push{.block = 0, .from_m = {0, height}, .to_m = {width, height}};
  for (auto* end : {&push.force_from_n_per_m2, &push.force_to_n_per_m2}) {
    *end = {scene::TimeTable::constant(0), scene::TimeTable::constant(0)};
    (*end)[static_cast<std::size_t>(axis)] = pulse(1e5, length_s);
  }
  scene.line_loads.push_back(push);
  Solid solid(scene);
  EnergyWatch energy;
  energy.look(solid);
  std::vector<Peak> peaks = {{height / 2, 0, 52 / c}, {height / 2, 58 / c, 130 / c}};
  run(solid, 130 / c, axis, peaks, &energy);
  const double expected = 1e5 / (density * c);
  const double error = integrator == scene::Integrator::shi ? 0.1 : 5e-3;
  EXPECT_NEAR(peaks[0].value, expected, error * expected);
  EXPECT_LT(std::abs(peaks[1].value), 0.01 * std::abs(peaks[0].value));
  EXPECT_LT(energy.gain(), 1e-3);
  EXPECT_LT(energy.now().kinetic + energy.now().strain, 1e-3 * solid.state().energy.given_j_per_m());
}

INSTANTIATE_TEST_SUITE_P(All, ViscousBoundaryOf,
                         testing::Combine(testing::Values(Wave::shear, Wave::pressure),
                                          testing::Values(scene::Integrator::shi, scene::Integrator::trapezoidal,
                                                          scene::Integrator::generalized_alpha)));

/// Half of the record comes up, the free surface doubles it, and all of it leaves. In the form "inertia" motions are
/// against the record's.
class ViscousBoundaryWith : public testing::TestWithParam<scene::Integrator> {};

TEST_P(ViscousBoundaryWith, TheFreeSurfaceMovesAsTheRecordHasIt) {
  const scene::Integrator integrator = GetParam();
  for (const Wave wave : {Wave::shear, Wave::pressure}) {
    for (const scene::BaseForm form : {scene::BaseForm::support, scene::BaseForm::inertia}) {
      const int axis = axis_of(wave);
      const double c = speed_of(wave);
      const double length_s = 30 / c;
      auto scene = column(wave, 2, 0.5 / c);
      scene.supports.clear();  // they are the base's
      scene.analysis.integrator = integrator;
      scene.base_motion.emplace();
      scene.base_motion->form = form;
      (axis == 0 ? scene.base_motion->acceleration_x_m_per_s2 : scene.base_motion->acceleration_y_m_per_s2) =
          rate_of_pulse(0.1, length_s);
      scene.viscous_faces.push_back({.block = 0, .from_m = {width, 0}, .to_m = {width, height}});
      scene.viscous_faces.push_back({.block = 0, .from_m = {0, height}, .to_m = {0, 0}});
      Solid solid(scene);
      const BaseMotion& base = solid.model().base;
      const double dt = scene.analysis.step_s;
      EnergyWatch energy;
      energy.look(solid);
      double surface = 0;
      double up = 0;
      double left = 0;
      for (int n = 0; n < std::lround(150 / c / dt); ++n) {
        solid.advance(n * dt, (n + 1) * dt, {});
        energy.look(solid);
        const double t = (n + 1) * dt;
        const double frame = form == scene::BaseForm::inertia ? base.ground_velocity(t, false)[axis] : 0;
        const auto at = [&](double y) { return std::abs(velocity_at(solid, 0, {width / 2, y}, axis) + frame); };
        surface = std::max(surface, at(height));
        if (t < 52 / c) up = std::max(up, at(height / 2));
        if (t > 130 / c) left = std::max({left, at(0), at(height / 2), at(height)});
      }
      EXPECT_NEAR(surface, 0.1, 5e-4);
      EXPECT_NEAR(up, 0.05, 2.5e-4);
      EXPECT_LT(left, 1e-5);
      EXPECT_LT(energy.gain(), 1e-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ViscousBoundaryWith,
                         testing::Values(scene::Integrator::trapezoidal, scene::Integrator::generalized_alpha));

/// 1/sqrt(cos^2 kH + (alpha sin kH)^2), alpha the impedance of the layer over that of the half space.
TEST(ViscousBoundary, ASoftLayerAmplifiesWhatTheHalfSpaceBrings) {
  constexpr double alpha = 0.2;
  for (const double kH : {0.8, std::numbers::pi / 2, 2.2}) {
    const double omega = kH * shear_speed / height;
    const double period = 2 * std::numbers::pi / omega;
    auto scene = column(Wave::shear, 4, period / 100);
    scene.materials.push_back({"rock", E / alpha / alpha, nu, density});  // five times the speed
    scene.viscous_faces[0].material = 1;
    scene.base_motion.emplace();
    scene.base_motion->acceleration_x_m_per_s2.sine = {1, omega, 0};
    Solid solid(scene);
    double low = 0;
    double high = 0;
    for (int n = 0; n < 100 * 16; ++n) {
      const double dt = scene.analysis.step_s;
      solid.advance(n * dt, (n + 1) * dt, {});
      if (n < 100 * 15) continue;
      const double t = (n + 1) * dt;
      const double v = velocity_at(solid, 0, {width / 2, height}, 0) + solid.model().base.ground_velocity(t, false).x();
      low = std::min(low, v);
      high = std::max(high, v);
    }
    const double got = (high - low) / 2 * omega;  // the record's velocity has the amplitude 1/omega
    const double expected = 1 / std::hypot(std::cos(kH), alpha * std::sin(kH));
    EXPECT_NEAR(got, expected, 0.002 * expected) << kH;
  }
}

/// Blocks of one strain each, bonded, with weight: the ground is held while it settles, and what held it goes on.
TEST(ViscousBoundary, GroundThatBearsAWeightStaysAtRestAndComesBackToTheBit) {
  scene::Scene scene;
  scene.materials.push_back({"rock", E, nu, density});
  scene.default_joint.friction_angle_deg = 40;
  for (int i = 0; i < 4; ++i) {
    const double y = 5.0 * i;
    scene.blocks.push_back({.name = "b" + std::to_string(i), .vertices = {{0, y}, {20, y}, {20, y + 5}, {0, y + 5}}});
  }
  scene.viscous_faces.push_back({.block = 0, .from_m = {0, 0}, .to_m = {20, 0}});
  scene.analysis.integrator = scene::Integrator::generalized_alpha;
  scene.analysis.step_s = 1e-3;
  scene.analysis.sleep = false;
  scene.base_motion.emplace();
  scene.base_motion->acceleration_x_m_per_s2 = {{0, 0.5, 0.500001}, {0, 0, 1}};
  Solid solid(scene);
  solid.settle({});
  ASSERT_TRUE(solid.starts_at_rest());
  const double settled = solid.largest_displacement_m();
  const auto steps = [](Solid& s, int from, int to) {
    for (int n = from; n < to; ++n) s.advance(n * 1e-3, (n + 1) * 1e-3, {});
  };
  steps(solid, 0, 500);
  EXPECT_NEAR(solid.largest_displacement_m(), settled, 1e-9 * settled);
  steps(solid, 500, 520);
  EXPECT_GT(std::abs(solid.states()[3].velocity[0]), 1e-4);

  const std::string kept = checkpoint::pack(solid);
  Solid again(scene);
  checkpoint::unpack(kept, again);
  steps(solid, 520, 560);
  steps(again, 520, 560);
  for (std::size_t b = 0; b < solid.states().size(); ++b) {
    EXPECT_EQ(solid.states()[b].displacement, again.states()[b].displacement);
    EXPECT_EQ(solid.states()[b].velocity, again.states()[b].velocity);
  }
}

}  // namespace
}  // namespace blockweir::solid::viscous_boundary_test
