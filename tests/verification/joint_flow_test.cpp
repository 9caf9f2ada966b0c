// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic solid_answers bridge_scene_read nlohmann_json::nlohmann_json
// Dams whose uplift is that of water which flows through their joints, against moments and forces by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "bridge/process/answers.hpp"
#include "bridge/process/sides.hpp"
#include "bridge/scene/read/read.hpp"

namespace blockweir::test::joint_flow_test {
namespace {

constexpr double unit_weight = 9810;

nlohmann::json level_of(const std::string& text) {
  return process::level_answer(scene::read_text(text, "dam").scene, hydrostatic::make);
}

/// A rectangular monolith on level rock, its joint 10 m and more from the model's ends; uplift by the joint's
/// apertures, in stretches of these shares of its width.
struct Monolith {
  double width;
  double height;
  double density;
  double friction_deg;
  std::vector<double> shares;   ///< of the width, ascending, the last one 1
  std::vector<double> factors;  ///< on the aperture, by stretch
};

Monolith random_monolith(std::mt19937_64& random) {
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  Monolith m{.width = between(4, 9),
             .height = 10,
             .density = between(2200, 2500),
             .friction_deg = between(20, 35),
             .shares = {between(0.1, 0.3), between(0.4, 0.6), between(0.7, 0.9), 1},
             .factors = {}};
  for (int i = 0; i < 4; ++i) m.factors.push_back(std::exp(between(std::log(0.2), std::log(2.0))));
  return m;
}

/// Of the uplift, the mouth's pressure and the width being 1: the fall in each stretch goes by length over aperture
/// cubed.
struct Uplift {
  double force = 0;
  double about_toe = 0;
};

Uplift uplift_of(const Monolith& m) {
  double resistance = 0;
  const auto from = [&](std::size_t i) { return i > 0 ? m.shares[i - 1] : 0; };
  for (std::size_t i = 0; i < m.shares.size(); ++i) resistance += (m.shares[i] - from(i)) / std::pow(m.factors[i], 3);
  double pressure = 1;
  Uplift sum;
  for (std::size_t i = 0; i < m.shares.size(); ++i) {
    const double length = m.shares[i] - from(i);
    const double next = pressure - length / std::pow(m.factors[i], 3) / resistance;
    const double near = 1 - m.shares[i];  // distance of its ends from the toe
    const double far = 1 - from(i);
    sum.force += length * (pressure + next) / 2;
    sum.about_toe += length / 6 * (pressure * (2 * far + near) + next * (far + 2 * near));
    pressure = next;
  }
  return sum;
}

/// The level at which it slides or turns over, whichever comes first.
double failure_level(const Monolith& m) {
  const Uplift uplift = uplift_of(m);
  const double friction = std::tan(m.friction_deg * std::numbers::pi / 180);
  const double weight = m.density * 9.81 * m.width * m.height;
  // rho g z^2/2 = (W - force rho g z B) tan(phi)
  const double b = uplift.force * m.width * friction;
  const double slides = -b + std::sqrt(b * b + 2 * weight * friction / unit_weight);
  double low = 0;
  double high = 2 * m.height;
  while (high - low > 1e-12 * m.height) {
    const double z = (low + high) / 2;
    const double turns =
        unit_weight * (z * z * z / 6 + uplift.about_toe * m.width * m.width * z) - weight * m.width / 2;
    (turns > 0 ? high : low) = z;
  }
  return std::min(slides, high);
}

std::string text_of(const Monolith& m) {
  std::string text = fmt::format(
      R"(analysis = {{ duration_s = 1, step_s = 0.01, rigid = "all" }}
material.m = {{ youngs_modulus_pa = 30e9, poissons_ratio = 0.2, density_kg_per_m3 = {} }}
joint = {{ friction_angle_deg = {}, uplift = "flow", hydraulic_aperture_m = 1e-3 }}
water = {{ upstream_level_m = 5 }}
[[block]]
name = "rock"
material = "m"
fixed = true
vertices_m = [[-20, -5], [30, -5], [30, 0], [-20, 0]]
[[block]]
name = "monolith"
material = "m"
vertices_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
)",
      m.density, m.friction_deg, m.width, m.width, m.height, m.height);
  double from = 0;
  for (std::size_t i = 0; i < m.shares.size(); ++i) {
    const double to = m.shares[i] * m.width;
    text += fmt::format(
        "[[grout]]\nname = \"g{}\"\noutline_m = [[{}, -1], [{}, -1], [{}, 1], [{}, 1]]\naperture_factor = {}\n", i,
        from, to, to, from, m.factors[i]);
    from = to;
  }
  return text;
}

TEST(JointFlow, MonolithsFailAtTheLevelThatTheirSeepageSays) {
  std::mt19937_64 random(20261127);
  for (int i = 0; i < 40; ++i) {
    const Monolith m = random_monolith(random);
    const double z = failure_level(m);
    const nlohmann::json found = level_of(text_of(m));
    SCOPED_TRACE(fmt::format("dam {}: {}\n{}", i, found.dump(), text_of(m)));
    if (z >= m.height) continue;
    ASSERT_TRUE(found["level_m"].is_number());
    EXPECT_NEAR(found["limit_analysis"]["level_m"].get<double>(), z, 1e-8 * z);
    EXPECT_NEAR(found["level_m"].get<double>(), z, 1e-8 * z);
  }
}

}  // namespace
}  // namespace blockweir::test::joint_flow_test
