// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_process fluid_hydrostatic fluid_reservoir bridge_scene_read
// A wall on a spring swings against a reservoir that carries sound, beside a solution of its own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "bridge/process/sides.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::process::sound_test {
namespace {

constexpr double H = 100;
constexpr double sound = 1440;
constexpr double speed = 0.05;
constexpr double spring = 1e9;
constexpr double mass = 2500.0 * 10 * 110;
constexpr double duration = 3;

std::string scene_text(double window_s) {
  return fmt::format(R"(analysis = {{ duration_s = {0}, step_s = {1}, integrator = "trapezoidal", rigid = "all" }}
material.c = {{ youngs_modulus_pa = 3e10, poissons_ratio = 0.2, density_kg_per_m3 = 2500 }}
output = {{ history_every_s = 0.01, frame_every_s = 10 }}
coupling = {{ window_s = {1}, schedule = "improved" }}
water = {{ upstream_level_m = {2} }}
fluid = {{ model = "reservoir", reservoir = {{ compressible = true, sound_speed_m_per_s = {3} }} }}
support = [{{ block = "w", point_m = [0, 0], displacement_y_m = 0 }}, {{ block = "w", point_m = [10, 0], displacement_y_m = 0 }}]
[[bolt]]
name = "spring"
from_block = "w"
from_m = [10, 30]
to_m = [110, 30]
stiffness_n_per_m2 = {4}
takes_compression = true
[[block]]
name = "w"
material = "c"
vertices_m = [[0, 0], [10, 0], [10, 110], [0, 110]]
initial_velocity_m_per_s = [{5}, 0]
[[block]]
name = "g"
material = "c"
fixed = true
vertices_m = [[-100, -20], [10, -20], [10, -0.1], [-100, -0.1]]
)",
                     duration, window_s, H, sound, spring, speed);
}

/// Every 10 ms, since the start.
std::vector<double> run(double window_s, const std::filesystem::path& folder) {
  std::ofstream(folder / "scene.toml") << scene_text(window_s);
  run_process({.scene = (folder / "scene.toml").string(), .folder = folder.string(), .make_fluid = reservoir::make});
  std::ifstream history(folder / "history.csv");
  std::string line;
  std::getline(history, line);
  int column = 0;
  std::istringstream names(line);
  for (std::string name; std::getline(names, name, ',') && name != "w.displacement_x_m";) ++column;
  std::vector<double> x;
  while (std::getline(history, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; i <= column; ++i) std::getline(cells, cell, ',');
    x.push_back(std::stod(cell));
  }
  for (std::size_t i = x.size(); i-- > 0;) x[i] -= x[0];
  return x;
}

/// m x'' + k x = -int h(t - s) x''(s) ds, h the sum over modes of the depth of 2 rho c/(H l^2) J0(l c t), l = (2q - 1)
/// pi/2H: a long reservoir between an upright wall and a level surface. Modes above the fortieth answer as
/// incompressible water.
std::vector<double> swing() {
  constexpr double step = 0.00125;
  constexpr int steps = static_cast<int>(duration / step);
  constexpr int modes = 40;
  const auto wave_number = [](int q) { return (2 * q - 1) * std::numbers::pi / (2 * H); };
  std::vector<double> h(steps + 1, 0.0);
  for (int i = 0; i <= steps; ++i) {
    for (int q = 1; q <= modes; ++q) {
      const double l = wave_number(q);
      h[static_cast<std::size_t>(i)] +=
          step * 2000 * sound / (H * l * l) * std::cyl_bessel_j(0, l * sound * (i + 0.5) * step);
    }
  }
  double total = mass;
  for (int q = modes + 1; q < 3000; ++q) total += 2000 / (H * std::pow(wave_number(q), 3));
  std::vector<double> a;
  std::vector<double> every;
  double x = 0;
  double v = speed;
  double before = 0;
  for (int i = 0; i < steps; ++i) {
    if (i % 8 == 0) every.push_back(x);
    double sum = 0;
    for (int j = 1; j <= i; ++j) sum += h[static_cast<std::size_t>(j)] * a[static_cast<std::size_t>(i - j)];
    const double now =
        (-spring * (x + v * step / 2) - (before + sum) / 2) / (total + spring * step * step / 4 + h[0] / 2);
    before = sum + h[0] * now;
    a.push_back(now);
    x += step * v + step * step / 2 * now;
    v += step * now;
  }
  every.push_back(x);
  return every;
}

/// Largest, over the largest of `exact`.
double difference(const std::vector<double>& found, const std::vector<double>& exact) {
  EXPECT_EQ(found.size(), exact.size());
  double worst = 0;
  double largest = 0;
  for (std::size_t i = 0; i < std::min(found.size(), exact.size()); ++i) {
    worst = std::max(worst, std::abs(found[i] - exact[i]));
    largest = std::max(largest, std::abs(exact[i]));
  }
  return worst / largest;
}

class Sound : public test::OwnFolder {};

/// What is left beside the exact swing is the mesh's: windows of half the length change it no more.
TEST_F(Sound, AWallOnASpringConvergesBySecondOrderToItsSwing) {
  const std::vector<double> coarse = run(0.01, folder);
  const std::vector<double> fine = run(0.005, folder);
  const std::vector<double> finest = run(0.0025, folder);
  EXPECT_LT(difference(finest, swing()), 0.006);
  EXPECT_GT(std::log2(difference(coarse, fine) / difference(fine, finest)), 1.7);
}

}  // namespace
}  // namespace blockweir::process::sound_test
