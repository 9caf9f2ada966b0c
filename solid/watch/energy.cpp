// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blockweir::solid {
namespace {

constexpr double most_gain = 1e-3;  // before it is warned of

}  // namespace

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
  const EnergyBalance& balance = solid.state().energy;
  double stored = balance.stored_j_per_m();
  for (const ContactPoint& c : solid.contacts()) stored += c.stored_j_per_m;
  const double own = now_.total() + stored - balance.given_j_per_m();
  lowest_ = begun_ ? std::min(lowest_, own) : own;
  made_ = std::max(made_, own - lowest_);
  const double had =
      now_.kinetic + std::abs(now_.strain) + std::abs(now_.potential) + std::abs(balance.given_j_per_m());
  // A structure that only strains and settles has almost no energy: the reference is the work of its weight in a
  // failure.
  if (!begun_) scale_ = solid.model().weight_n_per_m * solid.scene().analysis.failure_displacement_m;
  scale_ = std::max(scale_, had);
  begun_ = true;
}

std::string EnergyWatch::warning(const Solid& solid) const {
  const double made = gain();
  if (!(made > most_gain)) return {};
  return fmt::format(
      "numerical error has added {:.3g} J per metre, {:.3g} % of the run's energy: do not rely on the motion; expected "
      "at most {:.3g} %; shorten [analysis] step_s (now {:.3g}){}",
      made_, 100 * made, 100 * most_gain, solid.scene().analysis.step_s,
      solid.scene().analysis.integrator == scene::Integrator::shi ? "" : ", or take integrator = \"shi\"");
}

}  // namespace blockweir::solid
