// SPDX-License-Identifier: GPL-3.0-or-later
// Joints as a network of channels and nodes, with boundary conditions at its ends.
#pragma once

#include <vector>

#include "fluid/joints/channel.hpp"

namespace blockweir::joints {

enum class NodeKind {
  inside,  ///< inflow equals outflow
  held,    ///< by open water or a drain: the pressure is given
  seeps    ///< into air: pressure 0, and outflow only
};

struct Node {
  double height_m = 0;
  NodeKind kind = NodeKind::inside;
  double pressure_pa = 0;  ///< of a held node
};

struct Network {
  std::vector<Node> nodes;
  std::vector<Channel> channels;
};

struct WaterProperties {
  double viscosity_pa_s = 1.3e-3;
  double weight_n_per_m3 = 9810;  ///< rho g
  double bulk_modulus_pa = std::numeric_limits<double>::infinity();
};

/// State of the water by node: a pressure above 0 if it is full, otherwise the filled share.
struct Filling {
  std::vector<double> pressure_pa;
  std::vector<double> saturation;
  std::vector<double> flow;    ///< by channel, from its first node to its second [m2/s]
  std::vector<double> to_air;  ///< by node [m2/s]
};

}  // namespace blockweir::joints
