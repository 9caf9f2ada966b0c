// SPDX-License-Identifier: GPL-3.0-or-later
// Networks of joints to be solved in tests.
#pragma once

#include <vector>

#include "fluid/joints/network_flow.hpp"

namespace blockweir::joints {

inline constexpr double mu = 1.3e-3;

inline Node held(double pressure_pa, double height_m = 0) {
  return {height_m, NodeKind::held, pressure_pa};
}

/// Channels in a row, level, between two pressures; the number of nodes is one more.
inline Network row(const std::vector<Channel>& channels, double p1, double p2) {
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

inline Filling solved(const Network& network, const WaterProperties& water = {}) {
  Filling filling;
  NetworkFlow(water).steady(network, filling);
  return filling;
}

}  // namespace blockweir::joints
