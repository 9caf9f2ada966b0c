// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/energy.hpp"

#include <algorithm>
#include <cmath>

namespace blockweir::solid::output {

Energy energy_of(const Solid& solid) {
  Energy sum;
  for (std::size_t b = 0; b < solid.blocks().size(); ++b) {
    const Block& block = solid.blocks()[b];
    if (block.fixed || block.meshed) continue;  // of a meshed block its triangles count
    const BlockState& s = solid.states()[b];
    const Vector6 velocity = solid.velocity(b);
    sum.kinetic += velocity.dot(block.inertia * velocity) / 2;
    const auto strain = s.displacement.tail<3>();
    sum.strain += strain.dot(block.stiffness * strain) / 2 + block.area * block.initial_stress.dot(strain);
    sum.potential -= block.mass_per_m() * solid.scene().analysis.gravity().dot(s.displacement.head<2>());
  }
  for (const StrainCoupling& c : solid.parts().couplings) {
    const auto strain = [&](int t) { return solid.states()[static_cast<std::size_t>(t)].displacement.tail<3>(); };
    sum.strain += strain(c.i).dot(c.stiffness * strain(c.j));
  }
  return sum;
}

void EnergyWatch::look(const Solid& solid) {
  now_ = energy_of(solid);
  lowest_ = begun_ ? std::min(lowest_, now_.total()) : now_.total();
  begun_ = true;
  rise_ = std::max(rise_, now_.total() - lowest_);
  scale_ = std::max(scale_, now_.kinetic + std::abs(now_.strain) + std::abs(now_.potential));
}

}  // namespace blockweir::solid::output
