// SPDX-License-Identifier: GPL-3.0-or-later
// A slope of jointed rock above a valley, whose blocks wedge each other.
#pragma once

#include <fmt/format.h>

#include "bridge/scene/read/read.hpp"

namespace blockweir::test {

struct JointSet {
  double dip_deg;
  double spacing_m;
  double friction_deg;
};

inline scene::Scene jointed_abutment(const JointSet& foliation, const JointSet& cross, double modulus_pa = 20e9) {
  std::string text = fmt::format(R"(analysis = {{ duration_s = 1 }}
joint = {{ friction_angle_deg = 65 }}
material.granite = {{ youngs_modulus_pa = {}, poissons_ratio = 0.25, density_kg_per_m3 = 2650 }}
[[block]]
name = "bedrock"
material = "granite"
fixed = true
vertices_m = [[-30, -10], [60, -10], [60, 60], [50, 60], [20, 0], [-30, 0]]
[section]
material = "granite"
outline_m = [[5, 0], [20, 0], [50, 60], [35, 55], [20, 30]]
)",
                                 modulus_pa);
  for (const auto& [name, set] : {std::pair("foliation", foliation), std::pair("cross", cross)}) {
    text +=
        fmt::format("[[joint_set]]\nname = \"{}\"\ndip_deg = {:.6g}\nspacing_m = {:.6g}\nfriction_angle_deg = {:.6g}\n",
                    name, set.dip_deg, set.spacing_m, set.friction_deg);
  }
  return scene::read_text(text, "slope").scene;
}

}  // namespace blockweir::test
