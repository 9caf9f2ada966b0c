// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_joints
// Flow in time through networks of joints: water forced in, flowing in, running out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "tests/unit/networks.hpp"

namespace blockweir::joints::network_filling_test {
namespace {

/// Of PHYSICS.md section 6: a joint of 25 m whose mouth is at 11.9 MPa from time 0 on.
struct Injected {
  double worst_pressure;
  double volume;
};
Injected injected(int panels, double step_s) {
  const double k = 1e11;
  const double rest = 11e6;
  std::vector<Channel> channels(
      static_cast<std::size_t>(panels),
      {.length_m = 25.0 / panels, .aperture_m = {1e-5 - rest / k, 1e-5 - rest / k}, .compliance_m_per_pa = 1 / k});
  const Network network = row(channels, 11.9e6, rest);
  NetworkFlow flow({.viscosity_pa_s = 1e-3, .weight_n_per_m3 = 0});
  Filling filling{std::vector<double>(network.nodes.size(), rest), std::vector<double>(network.nodes.size(), 1.0), {}};
  std::vector<double> stored = flow.stored(network, filling);
  double before = 0;
  for (const double volume : stored) before += volume;
  for (double time = 0; time < 500 - step_s / 2; time += step_s) flow.step(network, step_s, {}, filling, stored);
  double after = 0;
  for (const double volume : stored) after += volume;
  const std::pair<double, double> expected[] = {{1, 11.8225e6}, {2, 11.7356e6}, {4, 11.5302e6}, {6, 11.2897e6}};
  Injected result{0, after - before};
  for (const auto& [x, p] : expected) {
    const double found = filling.pressure_pa[static_cast<std::size_t>(std::lround(x / 25 * panels))];
    result.worst_pressure = std::max(result.worst_pressure, std::abs(found - p) / 0.9e6);
  }
  return result;
}

TEST(NetworkFlow, WaterForcedIntoAnElasticJointFollowsTheSimilaritySolution) {
  const Injected fine = injected(100, 1);
  EXPECT_LT(fine.worst_pressure, 0.002);
  EXPECT_NEAR(fine.volume / 4.17765e-5, 1, 0.005);
  // Errors close with panels and with steps.
  EXPECT_LT(fine.worst_pressure, 0.5 * injected(50, 1).worst_pressure + 1e-4);
  EXPECT_LT(fine.worst_pressure, 0.5 * injected(100, 8).worst_pressure);
}

TEST(NetworkFlow, WhatAPoolHasLeftDrainsByItsOwnWeight) {
  // A joint that falls by 3 m, both ends in air since the pool has gone.
  Network network;
  constexpr int channels = 20;
  for (int i = 0; i <= channels; ++i) {
    network.nodes.push_back({.height_m = 3 - 3.0 * i / channels});
    if (i > 0) network.channels.push_back({i - 1, i, 5.0 / channels, {1e-3, 1e-3}});
  }
  network.nodes.front().kind = network.nodes.back().kind = NodeKind::seeps;
  NetworkFlow flow({.bulk_modulus_pa = 2.2e9});
  Filling filling{std::vector<double>(channels + 1, 0.0), std::vector<double>(channels + 1, 1.0), {}};
  std::vector<double> stored = flow.stored(network, filling);
  const auto sum = [&] { return std::accumulate(stored.begin(), stored.end(), 0.0); };
  const double full = sum();
  flow.step(network, 0.1, {}, filling, stored);
  const double q = std::pow(1e-3, 3) / (12 * mu) * 9810 * 3 / 5;  // at no pressure the fall is its own
  EXPECT_NEAR(full - sum(), 0.1 * q, 0.05 * 0.1 * q);
  double out = full - sum();
  for (int i = 0; i < 400; ++i) {
    const double before = sum();
    flow.step(network, 0.1, {}, filling, stored);
    EXPECT_NEAR(before - sum(), 0.1 * outflow(network, filling, NodeKind::seeps), 1e-12 * full);
    out += before - sum();
  }
  EXPECT_GT(out, 0.9 * full);
}

TEST(NetworkFlow, WhatFlowsInIsStored) {
  Network network =
      row({Channel{.length_m = 5, .aperture_m = {1e-3, 1e-3}}, Channel{.length_m = 5, .aperture_m = {1e-3, 5e-4}}},
          3 * 9810.0, 0);
  network.nodes[1].height_m = 1;
  network.nodes[2] = {.height_m = 2};
  NetworkFlow flow({.bulk_modulus_pa = 2.2e9});
  Filling filling{{3 * 9810.0, 0, 0}, {1, 0, 0}, {}};
  std::vector<double> stored = flow.stored(network, filling);
  const auto sum = [&] { return stored[1] + stored[2]; };  // the mouth's own half is its pool's
  for (int i = 0; i < 200; ++i) {
    const double before = sum();
    flow.step(network, 1, {}, filling, stored);
    EXPECT_NEAR(sum() - before, filling.flow[0], 1e-15 + 1e-10 * sum());
  }
  EXPECT_NEAR(filling.pressure_pa[2], 9810, 20);  // in the end it stands as high as outside
}

/// Partly dry above its pool, a loop of joints whose apertures differ by five powers of ten: one of many that a search
/// at random finds.
TEST(NetworkFilling, FlowThatIsNotFoundIsToldWithWhatHelps) {
  const auto joint = [](int from, int to, double length_m, double w1_m, double w2_m) {
    return Channel{.from = from, .to = to, .length_m = length_m, .aperture_m = {w1_m, w2_m}, .least_m = 1e-8};
  };
  Network network;
  network.nodes = {held(14475.1), {5.15185}, {15.6554}, {2.54969}, {0.744452}, {1.33481, NodeKind::seeps}};
  network.channels = {joint(0, 1, 5.05094, 5.29408e-05, 5.09909e-09), joint(1, 2, 6.46983, 3.98571e-08, 0.000854707),
                      joint(2, 3, 4.7531, 0.000638945, 0.00108481),   joint(3, 4, 0.244192, 5.92147e-07, 7.79712e-09),
                      joint(4, 5, 17.3009, 7.62352e-06, 2.27357e-07), joint(4, 1, 0.374531, 5.2807e-08, 9.64622e-08)};
  network.channels[0].compliance_m_per_pa = 1.25893e-13;
  std::string said = "nothing";
  try {
    solved(network);
  } catch (const std::runtime_error& error) {
    said = error.what();
  }
  EXPECT_THAT(said, testing::HasSubstr("no steady flow through the joints was found"));
  EXPECT_THAT(said, testing::HasSubstr("kind = \"transient\" in [joint_flow]"));
}

/// Blocks that a fall has pressed into each other close a joint: its water neither leaves nor can the joint widen.
TEST(NetworkFilling, WaterInAJointThatBlocksPressShutComesToRest) {
  Network network;
  network.nodes = {{.height_m = 0}, {.height_m = 4e-4}};
  network.channels = {{.from = 0,
                       .to = 1,
                       .length_m = 4e-4,
                       .aperture_m = {-2e-3, -2e-3},
                       .compliance_m_per_pa = 5e-9,
                       .least_m = 2e-6,
                       .largest_m = 2.5e-3}};
  WaterProperties water;
  water.bulk_modulus_pa = 2.2e9;
  NetworkFlow flow(water);
  Filling filling{{1500, 1500}, {1, 1}, {0}, {0, 0}};
  std::vector<double> stored = flow.stored(network, filling);
  for (double& volume : stored) volume = 4e-10 * (1 + 1500 / water.bulk_modulus_pa);
  flow.step(network, 0.01, {}, filling, stored);
  EXPECT_NEAR(filling.pressure_pa[0] - filling.pressure_pa[1], 4e-4 * water.weight_n_per_m3, 1e-3);
  EXPECT_NEAR((filling.pressure_pa[0] + filling.pressure_pa[1]) / 2, 1500, 1);
}

}  // namespace
}  // namespace blockweir::joints::network_filling_test
