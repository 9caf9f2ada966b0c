// SPDX-License-Identifier: GPL-3.0-or-later
// Water in cracks, by the law that the scene names: the same pressure on both faces.
#pragma once

#include <vector>

#include "bridge/scene/joint_trace.hpp"
#include "bridge/wire/message.hpp"
#include "fluid/hydrostatic/wet_edges.hpp"

namespace blockweir::hydrostatic {

/// The stretch of a crack between two blocks.
struct CrackPart {
  int block_a = 0;
  int block_b = 0;
  scene::JointTrace trace;
};

/// Parts in order from the mouth.
struct Crack {
  scene::Uplift law = scene::Uplift::none;
  std::vector<CrackPart> parts;
  double length_m = 0;
};

/// Joints with an uplift law. One that begins where another of the same law ends, and goes on within 45 degrees of its
/// direction, is the same crack; of several such the straightest.
std::vector<Crack> find_cracks(const scene::Scene& scene);

/// Adds both faces of the crack: uniform pressure (full uplift), or falling linearly from mouth to end (triangular).
/// Each piece has n elements, the same on both faces. What `open_water` reaches, by block, edge and place, is pressed
/// by that alone.
void add_crack_elements(const Crack& crack, double mouth_pressure_pa, double end_pressure_pa, int elements_per_face,
                        const std::vector<WetInterval>& open_water, wire::Load& load);

}  // namespace blockweir::hydrostatic
