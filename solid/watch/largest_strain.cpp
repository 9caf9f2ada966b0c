// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/largest_strain.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

constexpr double large = 0.05;

/// What to look at: supports that pull at one block come first, as nothing yields between them.
std::string advice(const Solid& solid, int block) {
  const auto& supports = solid.scene().supports;
  const auto held = std::count_if(supports.begin(), supports.end(), [&](const auto& s) { return s.block == block; });
  if (held > 1) {
    return fmt::format("its {} supports pull it apart or together: look at their displacements, for mm written as m",
                       held);
  }
  const scene::Material& material = solid.scene().materials[at(solid.scene().blocks[at(block)].material)];
  return fmt::format("is youngs_modulus_pa = {:.4g} of material \"{}\" in Pa, and are its loads in N?",
                     material.youngs_modulus_pa, material.name);
}

}  // namespace

void LargestStrain::look(const Solid& solid, double time_s) {
  const auto look_at = [&](int part, int block) {
    const double strain = solid.states()[at(part)].displacement.tail<3>().cwiseAbs().maxCoeff();
    if (strain <= strain_) return;
    strain_ = strain;
    block_ = block;
    time_s_ = time_s;
  };
  for (int b = 0; b < static_cast<int>(solid.described()); ++b) {
    for (const int triangle : solid.parts().triangles[at(b)]) look_at(triangle, b);
    if (!solid.blocks()[at(b)].meshed) look_at(b, b);
  }
}

std::string LargestStrain::warning(const Solid& solid) const {
  if (!(strain_ > large)) return {};
  return fmt::format(
      "block \"{}\" is strained by {:.3g} at {:.4g} s, which no rock or concrete bears: do not rely on its motion or "
      "stress; expected at most {:g}; {}",
      solid.scene().blocks[at(block_)].name, strain_, time_s_, large, advice(solid, block_));
}

}  // namespace blockweir::solid
