// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/oscillations.hpp"

#include <algorithm>

namespace blockweir::solid {
namespace {

bool has_springs(const scene::Scene& scene) {
  return scene.contact.formulation == scene::ContactFormulation::penalty;
}

}  // namespace

bool anything_strains(const Solid& solid) {
  const auto strains = [](const Block& block) { return !block.fixed && !block.rigid; };
  return has_springs(solid.scene()) || !solid.scene().bolts.empty() ||
         std::any_of(solid.blocks().begin(), solid.blocks().end(), strains);
}

bool velocities_ring(const Solid& solid) {
  return solid.scene().analysis.integrator != scene::Integrator::shi || has_springs(solid.scene());
}

}  // namespace blockweir::solid
