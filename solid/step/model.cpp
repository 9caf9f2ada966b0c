// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solid/contact/neighbours.hpp"
#include "solid/step/determinacy.hpp"

namespace blockweir::solid {
namespace {

/// Half the height of what can move, or half its width if that is less flat.
double model_size(const scene::Scene& scene) {
  Box box;
  for (const auto& block : scene.blocks) {
    if (block.fixed) continue;
    for (const auto& vertex : block.vertices) box.extend(vertex);
  }
  return box.isEmpty() ? 1.0 : box.sizes().maxCoeff() / 2;
}

/// Of all coordinates, those of a wide ground among them: what positions are known to is a round-off of it [m].
double farthest_coordinate(const scene::Scene& scene) {
  double farthest = 0;
  for (const auto& block : scene.blocks) {
    for (const auto& vertex : block.vertices) farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
  }
  return farthest;
}

/// Weight of all that can move; without gravity their mass at 1 m/s2.
double weight_of_all(const std::vector<Block>& blocks, double gravity) {
  double mass = 0;
  for (const Block& block : blocks) mass += block.fixed || block.is_part() ? 0 : block.mass_per_m();
  return mass > 0 ? mass * (gravity > 0 ? gravity : 1.0) : 1.0;
}

double largest_modulus(const scene::Scene& scene) {
  double largest = 0;
  for (const auto& material : scene.materials) largest = std::max(largest, material.youngs_modulus_pa);
  return largest;
}

}  // namespace

Model::Model(const scene::Scene& described)
    : scene(described),
      parts(make_moving_parts(scene)),
      blocks(parts.blocks),
      laws(scene),
      loads(scene, parts),
      base(scene),
      boundary(scene, parts),
      water_motions(scene, parts),
      size_m(model_size(scene)),
      weight_n_per_m(weight_of_all(blocks, scene.analysis.gravity_m_per_s2)),
      scheme(Newmark::of(scene.analysis.integrator, scene.analysis.spectral_radius)) {
  scheme.damps = is(scene::AnalysisKind::dynamic);
}

FormulationSettings Model::contact_settings() const {
  return {.penetration_tolerance_m = scene.contact.penetration_tolerance_m,
          .force_tolerance_n = scene.contact.force_tolerance * weight_n_per_m,
          .position_round_off_m = 2 * std::numeric_limits<double>::epsilon() * farthest_coordinate(scene),
          .initial_penalty = scene.contact.initial_penalty_n_per_m2,
          .contact_stiffness = scene.contact.stiffness_n_per_m2,
          .dashpot_ratio = scene.contact.dashpot_ratio,
          .largest_modulus_pa = largest_modulus(scene)};
}

double Model::typical_width_m() const {
  std::vector<double> widths;
  for (const Block& block : blocks) {
    if (block.fixed || block.is_part()) continue;
    Box box;
    for (const Point& vertex : block.vertices) box.extend(vertex);
    widths.push_back(box.sizes().minCoeff());
  }
  if (widths.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  return *middle;
}

double Model::find_give() const {
  constexpr double share = 4;    // of a column's shortening, rho g L^2/E
  constexpr double most = 1e-2;  // of a block's width
  const bool springs = scene.contact.formulation == scene::ContactFormulation::penalty;
  double give = 0;
  for (const Block& block : blocks) {
    if (!springs && (block.rigid || block.fixed)) continue;
    double modulus = block.elasticity(0, 0);
    if (springs) modulus = std::min(modulus, scene.contact.stiffness_n_per_m2.value_or(modulus));
    const double weight = block.mass_per_m() / block.area * scene.analysis.gravity_m_per_s2;
    give = std::max(give, share * weight * size_m * size_m / modulus);
  }
  return std::min(give, most * typical_width_m());
}

double Model::pseudo_step_s() const {
  double longest = 0;
  for (const Block& block : blocks) {
    if (block.fixed) continue;
    const double modulus = block.stiffness(0, 0) / block.area;
    if (modulus > 0) longest = std::max(longest, std::sqrt(2e4 * block.mass_per_m() / modulus));
  }
  return longest;
}

double Model::settling_time_s() const {
  return is(scene::AnalysisKind::at_rest) ? scene.analysis.duration_s : 0;
}

void Model::make_rigid(const std::vector<ContactPoint>& contacts) {
  const std::vector<bool> rigid = rigid_blocks(scene, blocks, contacts);
  for (std::size_t b = 0; b < blocks.size(); ++b) parts.blocks[b].rigid = rigid[b];
  give_under_weight_m = find_give();
}

}  // namespace blockweir::solid
