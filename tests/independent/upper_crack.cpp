// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/independent/upper_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace blockweir::independent {
namespace {

constexpr double g = 9.81;
constexpr double water = 1000;
constexpr double crack_x = 9.4175;
constexpr double crack_y = 15 - 11.6361;
constexpr double area_m2 = [] {  // of the polygon in scene()
  constexpr std::array<std::array<double, 2>, 5> p{{{0, 15}, {9.4175, 11.6361}, {4, 22}, {4, 27}, {0, 27}}};
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& a = p[i];
    const auto& b = p[(i + 1) % p.size()];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return twice / 2;
}();

double normal_below(double u) {
  return std::erfc(-u / std::numbers::sqrt2) / 2;
}

/// Simpson's nodes of a standard normal variable and their weights; one node where there is no deviation.
struct Node {
  double value;
  double weight;
};
std::vector<Node> nodes_of(const std::array<double, 2>& normal, int intervals) {
  if (normal[1] == 0) return {{normal[0], 1}};
  constexpr double reach = 6;
  std::vector<Node> nodes;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double u = reach * (2.0 * i / intervals - 1);
    const double weight = (i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2) * std::exp(-u * u / 2);
    nodes.push_back({normal[0] + normal[1] * u, weight});
    sum += weight;
  }
  for (Node& node : nodes) node.weight /= sum;
  return nodes;
}

}  // namespace

double UncertainCrack::head_m(double phi_deg, double bond_pa, double density) const {
  const double a = std::atan2(crack_y, crack_x);
  const double weight = density * g * area_m2;
  const double tan_phi = std::tan(phi_deg * std::numbers::pi / 180);
  const double strength = weight * (std::cos(a) * tan_phi - std::sin(a)) + bond_pa * std::hypot(crack_x, crack_y);
  const double force = strength / (std::cos(a) + std::sin(a) * tan_phi);
  return std::sqrt(2 * std::max(0.0, force) / (water * g));  // 0: it does not even stand without water
}

double UncertainCrack::below(double head_m) const {
  const double a = std::atan2(crack_y, crack_x);
  const double force = water * g * head_m * head_m / 2;
  double sum = 0;
  for (const Node& cohesion : nodes_of(cohesion_pa, 200)) {
    for (const Node& density : nodes_of(density_kg_per_m3, 200)) {
      const double weight = density.value * g * area_m2;
      const double bond = cohesion.value * std::hypot(crack_x, crack_y);
      const double tan_phi =
          (force * std::cos(a) + weight * std::sin(a) - bond) / (weight * std::cos(a) - force * std::sin(a));
      const double phi_deg = std::atan(tan_phi) * 180 / std::numbers::pi;
      sum += cohesion.weight * density.weight * normal_below((phi_deg - friction_deg[0]) / friction_deg[1]);
    }
  }
  return sum;
}

UncertainCrack::Indices UncertainCrack::indices() const {
  constexpr int intervals = 60;
  const std::array<std::vector<Node>, 3> nodes{nodes_of(friction_deg, intervals), nodes_of(cohesion_pa, intervals),
                                               nodes_of(density_kg_per_m3, intervals)};
  const auto mean_over = [&](const std::array<bool, 3>& free, std::array<double, 3> at) {
    double mean = 0;
    std::function<void(std::size_t, double)> go = [&](std::size_t k, double weight) {
      if (k == 3) {
        mean += weight * head_m(at[0], at[1], at[2]);
      } else if (!free[k]) {
        go(k + 1, weight);
      } else {
        for (const Node& node : nodes[k]) {
          at[k] = node.value;
          go(k + 1, weight * node.weight);
        }
      }
    };
    go(0, 1);
    return mean;
  };
  /// Variance of the mean over the others, the variables `held` being held.
  const auto variance_of = [&](const std::array<bool, 3>& held) {
    const std::array<bool, 3> free{!held[0], !held[1], !held[2]};
    double mean = 0;
    double square = 0;
    std::array<double, 3> at{};
    std::function<void(std::size_t, double)> go = [&](std::size_t k, double weight) {
      if (k == 3) {
        const double value = mean_over(free, at);
        mean += weight * value;
        square += weight * value * value;
      } else if (!held[k]) {
        go(k + 1, weight);
      } else {
        for (const Node& node : nodes[k]) {
          at[k] = node.value;
          go(k + 1, weight * node.weight);
        }
      }
    };
    go(0, 1);
    return square - mean * mean;
  };
  const double all = variance_of({true, true, true});
  Indices found{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<bool, 3> alone{};
    std::array<bool, 3> others{true, true, true};
    alone[k] = true;
    others[k] = false;
    found.first[k] = variance_of(alone) / all;
    found.total[k] = 1 - variance_of(others) / all;
  }
  return found;
}

std::string UncertainCrack::scene() const {
  std::string text = fmt::format(R"([analysis]
duration_s = 1
step_s = 0.02
[material.concrete]
youngs_modulus_pa = 50e9
poissons_ratio = 0.2
density_kg_per_m3 = {}
[joint]
friction_angle_deg = 40
[[block]]
name = "base"
material = "concrete"
fixed = true
vertices_m = [[0, 0], [15.5, 0], [9.4175, 11.6361], [0, 15]]
[[block]]
name = "top"
material = "concrete"
vertices_m = [[0, 15], [9.4175, 11.6361], [4, 22], [4, 27], [0, 27]]
[[joints]]
name = "crack"
between = ["base", "top"]
friction_angle_deg = {}
cohesion_pa = {}
[water]
upstream_level_m = 20
)",
                                 density_kg_per_m3[0], friction_deg[0], cohesion_pa[0]);
  const auto random = [&](const char* name, const char* key, const std::array<double, 2>& normal) {
    if (normal[1] == 0) return;
    text +=
        fmt::format("[[random]]\nname = \"{}\"\nkey = \"{}\"\ndistribution = \"normal\"\nmean = {}\ndeviation = {}\n",
                    name, key, normal[0], normal[1]);
  };
  random("friction", "joints.crack.friction_angle_deg", friction_deg);
  random("cohesion", "joints.crack.cohesion_pa", cohesion_pa);
  random("density", "material.concrete.density_kg_per_m3", density_kg_per_m3);
  return text;
}

}  // namespace blockweir::independent
