// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_joints
// Steady flow through networks of joints against closed forms: several channels, with drains, elastic, partly dry.
#include "fluid/joints/network_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bridge/scene/at.hpp"
#include "tests/samples.hpp"
#include "tests/unit/networks.hpp"

namespace blockweir::joints::network_flow_test {
namespace {

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
  for (int i = 0; i < test::samples(200); ++i) {
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

}  // namespace
}  // namespace blockweir::joints::network_flow_test
