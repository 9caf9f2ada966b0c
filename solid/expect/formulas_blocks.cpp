// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks under their own weight.
#include "bridge/geometry/polygon.hpp"
#include "solid/expect/formula_tables.hpp"

namespace blockweir::solid::expect {
namespace {

/// Its part along the y axis, against which a reaction stands.
double weight_of_all(const Scene& s, const std::string&) {
  double sum = 0;
  for (const auto& block : s.blocks) sum += block.fixed ? 0 : weight(s, block);
  return sum * -s.analysis.gravity().normalized().y();
}

/// On a level joint: weights of all that can move and lies higher than it, whatever is beside it.
double weight_above(const Scene& s, const std::string& subject) {
  const double level = plane_joint(s, subject).mouth.y();
  double sum = 0;
  for (const auto& block : s.blocks) {
    if (!block.fixed && geometry::centroid(block.vertices).y() > level) sum += weight(s, block);
  }
  return sum;
}

/// -rho g h/2
double own_weight_stress(const Scene& s, const std::string& subject) {
  const scene::Block& b = block_named(s, subject);
  return -material_of(s, b).density_kg_per_m3 * s.analysis.gravity_m_per_s2 * height(b) / 2;
}

/// rho g h^2/(2 E)
double own_weight_shortening(const Scene& s, const std::string& subject) {
  const scene::Block& b = block_named(s, subject);
  return -own_weight_stress(s, subject) * height(b) / material_of(s, b).youngs_modulus_pa;
}

}  // namespace

const Formulas& block_formulas() {
  static const Formulas all = {{"weight-of-all", weight_of_all},
                               {"weight-above", weight_above},
                               {"own-weight-stress", own_weight_stress},
                               {"own-weight-shortening", own_weight_shortening}};
  return all;
}

}  // namespace blockweir::solid::expect
