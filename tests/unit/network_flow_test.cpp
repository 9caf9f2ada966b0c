// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_joints
// Flow through networks of joints against closed forms: one channel, several, with drains, elastic, filling, draining.
#include "fluid/joints/network_flow.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "bridge/scene/at.hpp"

namespace blockweir::joints {
namespace {

constexpr double mu = 1.3e-3;

Node held(double pressure_pa, double height_m = 0) {
  return {height_m, NodeKind::held, pressure_pa};
}

/// Channels in a row, level, between two pressures; the number of nodes is one more.
Network row(const std::vector<Channel>& channels, double p1, double p2) {
  Network network;
  network.nodes.assign(channels.size() + 1, Node{});
  network.nodes.front() = held(p1);
  network.nodes.back() = held(p2);
  network.channels = channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    network.channels[i].from = static_cast<int>(i);
    network.channels[i].to = static_cast<int>(i + 1);
  }
  return network;
}

Filling solved(const Network& network, const WaterProperties& water = {}) {
  Filling filling;
  NetworkFlow(water).steady(network, filling);
  return filling;
}

TEST(Channel, PressureHasForceAndMomentOfTheWedge) {
  for (const double ratio : {0.001, 0.1, 0.5, 0.97, 0.995, 1.0, 1.00001, 1.01, 1.03, 2.0, 10.0, 1000.0}) {
    const double length = 7;
    const std::array<double, 2> w = {2e-4, 2e-4 * ratio};
    const double p1 = 8e4;
    const double p2 = 1e4;
    const auto pressure = [&](double s) {
      if (ratio == 1) return p1 + (p2 - p1) * s / length;
      const double here = w[0] + (w[1] - w[0]) * s / length;
      // (w^-2 - w2^-2)/(w1^-2 - w2^-2), without differences of what is nearly equal
      const double share = (w[1] - here) * (w[1] + here) * w[0] * w[0] / ((w[1] - w[0]) * (w[1] + w[0]) * here * here);
      return p2 + (p1 - p2) * share;
    };
    double force = 0;
    double moment = 0;
    const int parts = 4000;
    for (int i = 0; i < parts; ++i) {
      using Gauss = boost::math::quadrature::gauss<double, 10>;
      // Parts as long as the aperture is wide: all of them see as much of the curve.
      const auto end = [&](double t) {
        if (std::abs(ratio - 1) < 0.1) return t * length;
        return (std::pow(ratio, t) - 1) / (ratio - 1) * length;
      };
      const double a = end(double(i) / parts);
      const double b = end(double(i + 1) / parts);
      force += Gauss::integrate(pressure, a, b);
      moment += Gauss::integrate([&](double s) { return s * pressure(s); }, a, b);
    }
    const Profile profile = flowing(length, w, {p1, 0}, {p2, 0}, 9810);
    EXPECT_NEAR(profile.force() / force, 1, 1e-10) << ratio;
    EXPECT_NEAR(profile.moment_about_mouth() / moment, 1, 1e-10) << ratio;
    for (const Profile::Knot& knot : profile.knots()) {
      EXPECT_GE(knot.pressure_pa, p2 * (1 - 1e-12)) << ratio;
      EXPECT_LE(knot.pressure_pa, p1 * (1 + 1e-12)) << ratio;
    }
    const double q = (p1 - p2) * w[0] * w[0] * w[1] * w[1] / (6 * mu * length * (w[0] + w[1]));
    EXPECT_NEAR(conductance(length, w, mu).value * (p1 - p2) / q, 1, 1e-12);
    EXPECT_NEAR(profile.force() / length, p2 + (p1 - p2) * w[0] / (w[0] + w[1]), 1e-10 * p1) << ratio;
  }
}

TEST(Channel, OpenTenToOneAtItsMouthHasTenElevenths) {
  EXPECT_NEAR(flowing(1, {1e-3, 1e-4}, {1e5, 0}, {0, 0}, 9810).force() / 1e5, 10.0 / 11, 1e-12);
  EXPECT_NEAR(flowing(1, {1e-4, 1e-3}, {1e5, 0}, {0, 0}, 9810).force() / 1e5, 1.0 / 11, 1e-12);
}

TEST(Channel, StandingWaterReachesAsHighAsItsPressure) {
  const Profile up = standing(5, {3 * 9810.0, 0}, {0, 4}, 9810);
  EXPECT_NEAR(up.force(), 9810 * 3 * 0.5 * 3 * 5.0 / 4, 1e-8);
  const Profile down = standing(5, {0, 4}, {3 * 9810.0, 0}, 9810);
  EXPECT_NEAR(down.force(), up.force(), 1e-8);
}

TEST(NetworkFlow, StepsOfApertureShareTheFallByTheirResistance) {
  std::mt19937_64 random(20261125);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int i = 0; i < 50; ++i) {
    std::vector<Channel> channels(5);
    double resistance = 0;
    for (Channel& c : channels) {
      c.length_m = between(0.1, 10);
      const double w = std::exp(between(std::log(1e-4), std::log(1e-3)));
      c.aperture_m = {w, w};
      resistance += 12 * mu * c.length_m / (w * w * w);
    }
    const Network network = row(channels, 9e4, 2e4);
    const Filling filling = solved(network);
    const double q = 7e4 / resistance;
    double p = 9e4;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      EXPECT_NEAR(filling.flow[c] / q, 1, 1e-10);
      EXPECT_NEAR(filling.pressure_pa[c], p, 1e-10 * 9e4);
      p -= q * 12 * mu * channels[c].length_m / std::pow(channels[c].aperture_m[0], 3);
    }
  }
}

TEST(NetworkFlow, TwoInParallelAddUp) {
  Network network =
      row({Channel{.length_m = 3, .aperture_m = {1e-4, 1e-4}}, Channel{.length_m = 4, .aperture_m = {3e-4, 3e-4}}}, 5e4,
          1e4);
  network.channels.push_back({.from = 1, .to = 2, .length_m = 9, .aperture_m = {2e-4, 2e-4}});
  const Filling filling = solved(network);
  const auto g = [](double w, double length) { return w * w * w / (12 * mu * length); };
  const double both = g(3e-4, 4) + g(2e-4, 9);
  const double first = g(1e-4, 3);
  EXPECT_NEAR(filling.pressure_pa[1], (first * 5e4 + both * 1e4) / (first + both), 1e-10 * 5e4);
  EXPECT_NEAR(filling.flow[0], 4e4 * first * both / (first + both), 1e-10 * filling.flow[0]);
  EXPECT_NEAR(filling.flow[0], filling.flow[1] + filling.flow[2], 1e-14 * filling.flow[0]);
}

TEST(NetworkFlow, ADrainPartsAJointInTwo) {
  Network network = row(
      {Channel{.length_m = 4, .aperture_m = {2e-4, 2e-4}}, Channel{.length_m = 6, .aperture_m = {2e-4, 2e-4}}}, 8e4, 0);
  network.nodes[1] = held(1e4);
  const Filling filling = solved(network);
  const double g = 8e-12 / (12 * mu);
  EXPECT_NEAR(filling.flow[0] / (g * 7e4 / 4), 1, 1e-10);
  EXPECT_NEAR(filling.flow[1] / (g * 1e4 / 6), 1, 1e-10);
}

/// w^4 is linear along an elastic joint.
double elastic_error(int panels) {
  const double k = 1e10;
  const double length = 12;
  std::vector<Channel> channels(
      static_cast<std::size_t>(panels),
      {.length_m = length / panels, .aperture_m = {1e-4, 1e-4}, .compliance_m_per_pa = 1 / k});
  const Filling filling = solved(row(channels, 8e5, 1e5));
  const double w1 = 1e-4 + 8e5 / k;
  const double w2 = 1e-4 + 1e5 / k;
  double worst = std::abs(filling.flow[0] / (k * (std::pow(w1, 4) - std::pow(w2, 4)) / (48 * mu * length)) - 1);
  for (int i = 0; i <= panels; ++i) {
    const double w = std::pow(std::pow(w1, 4) + (std::pow(w2, 4) - std::pow(w1, 4)) * i / panels, 0.25);
    worst = std::max(worst, std::abs(filling.pressure_pa[at(i)] - k * (w - 1e-4)) / 7e5);
  }
  return worst;
}

TEST(NetworkFlow, ElasticJointIsOfSecondOrderInItsPanels) {
  EXPECT_LT(elastic_error(60), 1e-4);
  EXPECT_NEAR(std::log2(elastic_error(20) / elastic_error(40)), 2, 0.1);
}

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

/// Joints square to each other at this spacing, horizontal ones half a spacing above the base.
double over_charny(int columns, int rows) {
  const double length = 10;
  const double height = 10;
  const double high = 8;
  const double low = 2;
  const double w = 5e-4;
  const double dx = length / columns;
  const double dy = height / rows;
  const WaterProperties water{.viscosity_pa_s = mu};
  Network network;
  const auto number = [&](int i, int j) { return i * rows + j; };
  for (int i = 0; i <= columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double y = (j + 0.5) * dy;
      const double level = i == 0 ? high : low;
      const bool end = i == 0 || i == columns;
      if (!end)
        network.nodes.push_back({y});
      else if (y < level)
        network.nodes.push_back(held(water.weight_n_per_m3 * (level - y), y));
      else
        network.nodes.push_back({y, NodeKind::seeps});
      if (i > 0) network.channels.push_back({number(i - 1, j), number(i, j), dx, {w, w}});
      if (j > 0 && !end) network.channels.push_back({number(i, j - 1), number(i, j), dy, {w, w}});
    }
  }
  const Filling filling = solved(network, water);
  double q = 0;
  for (std::size_t c = 0; c < network.channels.size(); ++c) {
    if (network.channels[c].from < rows && network.channels[c].to >= rows) q += filling.flow[c];
  }
  const double out = outflow(network, filling, NodeKind::held) + outflow(network, filling, NodeKind::seeps);
  EXPECT_LT(std::abs(out), 1e-12 * q);
  for (const double p : filling.pressure_pa) EXPECT_GE(p, 0);
  const double k = water.weight_n_per_m3 * w * w * w / (12 * mu * dy);
  return q / (k * (high * high - low * low) / (2 * length)) - 1;
}

TEST(NetworkFlow, TwoSetsOfJointsWithAFreeSurfaceCloseOnCharny) {
  EXPECT_LT(std::abs(over_charny(20, 20)), 0.02);
  EXPECT_LT(std::abs(over_charny(40, 40)), 0.01);
  EXPECT_LT(std::abs(over_charny(40, 40)), std::abs(over_charny(10, 10)) + 1e-3);
}

TEST(NetworkFlow, WaterDoesNotClimbOverWhatIsHigherThanItsLevel) {
  Network network =
      row({Channel{.length_m = 5, .aperture_m = {1e-3, 1e-3}}, Channel{.length_m = 5, .aperture_m = {1e-3, 1e-3}}},
          2 * 9810.0, 0);
  network.nodes[1].height_m = 3;
  network.nodes[2] = {.height_m = 0, .kind = NodeKind::seeps};
  const Filling filling = solved(network);
  EXPECT_EQ(filling.flow[1], 0);
  EXPECT_NEAR(filling.flow[0], 0, 1e-18);
  EXPECT_EQ(filling.pressure_pa[1], 0);
  EXPECT_LT(filling.saturation[1], 1);
}

TEST(NetworkFlow, AirGivesNoWater) {
  Network network = row({Channel{.length_m = 5, .aperture_m = {1e-3, 1e-3}}}, 1 * 9810.0, 0);
  network.nodes[1] = {.height_m = 4, .kind = NodeKind::seeps};
  EXPECT_EQ(solved(network).flow[0], 0);
}

TEST(NetworkFlow, WhatNothingFeedsIsDry) {
  Network network = row({Channel{.length_m = 5, .aperture_m = {1e-3, 1e-3}}}, 0, 0);
  for (Node& node : network.nodes) node = {};
  const Filling filling = solved(network);
  EXPECT_EQ(filling.pressure_pa, std::vector<double>(2, 0.0));
  EXPECT_EQ(filling.flow, std::vector<double>(1, 0.0));
}

/// A grid of random apertures, some pools and some faces in air.
Network random_grid(std::mt19937_64& random, int columns, int rows) {
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  Network network;
  const double level = between(0.2, 1.2) * rows;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double y = j + between(-0.2, 0.2);
      Node node{y};
      if (i == 0 && y < level) node = held(9810 * (level - y), y);
      if (i == columns - 1 && between(0, 1) < 0.7) node.kind = NodeKind::seeps;
      network.nodes.push_back(node);
      const int here = i * rows + j;
      const auto w = [&] { return std::exp(between(std::log(1e-5), std::log(1e-3))); };
      if (i > 0) network.channels.push_back({here - rows, here, between(0.5, 2), {w(), w()}});
      if (j > 0) network.channels.push_back({here - 1, here, between(0.5, 2), {w(), w()}});
    }
  }
  return network;
}

TEST(NetworkFlow, RandomNetworksLoseNoWaterAndHaveNoSuction) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200; ++i) {
    const Network network = random_grid(random, 3 + i % 12, 2 + i % 9);
    const Filling filling = solved(network);
    double terms = 0;  // whose differences the flows are
    std::vector<double> out(network.nodes.size(), 0.0);
    for (std::size_t c = 0; c < network.channels.size(); ++c) {
      const Channel& channel = network.channels[c];
      terms = std::max(terms, 9810 * 10 * conductance(channel.length_m, channel.aperture_m, mu).value);
      out[at(network.channels[c].from)] -= filling.flow[c];
      out[at(network.channels[c].to)] += filling.flow[c];
    }
    for (std::size_t n = 0; n < out.size(); ++n) {
      EXPECT_GE(filling.pressure_pa[n], 0);
      if (network.nodes[n].kind == NodeKind::inside) {
        EXPECT_LE(std::abs(out[n]), 1e-13 * terms) << i;
      }
      if (network.nodes[n].kind == NodeKind::seeps) {
        EXPECT_GE(out[n], -1e-13 * terms) << i;
      }
      if (filling.pressure_pa[n] > 0) {
        EXPECT_EQ(filling.saturation[n], 1) << i;
      }
    }
  }
}

TEST(NetworkFlow, AKeptFactorGivesTheSameFlow) {
  std::mt19937_64 random(11);
  Network network = random_grid(random, 30, 20);
  for (Node& node : network.nodes) {
    if (node.kind == NodeKind::held) node.pressure_pa += 5e5;
    if (node.kind == NodeKind::seeps) node = held(1e5, node.height_m);  // all of it full
  }
  NetworkFlow keeps({});
  for (int i = 0; i < 10; ++i) {
    for (Channel& c : network.channels) c.aperture_m[0] *= std::uniform_real_distribution(0.999, 1.001)(random);
    Filling kept;
    keeps.steady(network, kept);
    const Filling fresh = solved(network);
    for (std::size_t n = 0; n < network.nodes.size(); ++n) {
      EXPECT_NEAR(kept.pressure_pa[n], fresh.pressure_pa[n], 1e-9 * 7e5);
    }
  }
  EXPECT_EQ(keeps.factorizations(), 1);
  EXPECT_EQ(keeps.kept(), 9);
}

TEST(NetworkFlow, ARestoredFactorGivesTheSameBits) {
  std::mt19937_64 random(12);
  Network network = random_grid(random, 12, 9);
  for (Node& node : network.nodes) {
    if (node.kind == NodeKind::held) node.pressure_pa += 5e5;
  }
  NetworkFlow first({});
  Filling filling;
  first.steady(network, filling);
  NetworkFlow second({});
  second.restore(first.state());
  for (Channel& c : network.channels) c.aperture_m[1] *= 1.0005;
  Filling a;
  Filling b;
  first.steady(network, a);
  second.steady(network, b);
  EXPECT_EQ(a.pressure_pa, b.pressure_pa);
  EXPECT_EQ(a.flow, b.flow);
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

}  // namespace
}  // namespace blockweir::joints
