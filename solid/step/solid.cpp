// SPDX-License-Identifier: GPL-3.0-or-later
// Building the solid from a scene, and what can be asked of it.
#include "solid/step/solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "bridge/scene/check.hpp"
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

// Of half the structure's larger side: check_overlaps lets pieces pass whose area over their length is that share of a
// block's, wedges of twice that depth among them.
constexpr double widest_rounding = 2 * scene::rounding_ratio;
constexpr double deepest_rounding = 2 * widest_rounding;

/// Of all coordinates, those of a wide ground among them: what positions are known to is a round-off of it [m].
double farthest_coordinate(const scene::Scene& scene) {
  double farthest = 0;
  for (const auto& block : scene.blocks) {
    for (const auto& vertex : block.vertices) farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
  }
  return farthest;
}

/// Median over the movable blocks of the lesser side of the box around each [m].
double typical_width(const std::vector<Block>& blocks) {
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

std::vector<Support> make_supports(const scene::Scene& scene, const Parts& parts) {
  std::vector<Support> supports;
  for (const auto& described : scene.supports) {
    const Anchor anchor = parts.anchor(described.block, described.point_m);
    Support support;
    support.block = anchor.part;
    support.material = anchor.material;
    support.described = &described;
    supports.push_back(support);
  }
  return supports;
}

}  // namespace

Solid::Solid(const scene::Scene& scene)
    : scene_(scene),
      parts_(make_parts(scene)),
      blocks_(parts_.blocks),
      laws_(scene),
      loads_(scene, parts_),
      base_(scene),
      size_(model_size(scene)),
      force_scale_(weight_of_all(blocks_, scene.analysis.gravity_m_per_s2)),
      scheme_(Newmark::of(scene.analysis.integrator, scene.analysis.spectral_radius)),
      supports_(make_supports(scene, parts_)),
      next_dt_(scene.analysis.step_s),
      sleep_(blocks_.size(), size_),
      newmark_(scheme_),
      formulation_(make_formulation(
          scene.contact.formulation, laws_,
          {.penetration_tolerance_m = scene.contact.penetration_tolerance_m,
           .force_tolerance_n = scene.contact.force_tolerance * force_scale_,
           .position_round_off_m = 2 * std::numeric_limits<double>::epsilon() * farthest_coordinate(scene),
           .initial_penalty = scene.contact.initial_penalty_n_per_m2,
           .contact_stiffness = scene.contact.stiffness_n_per_m2,
           .dashpot_ratio = scene.contact.dashpot_ratio,
           .largest_modulus_pa = largest_modulus(scene)})),
      // A twentieth of a block's width is more than most steps move it, and meets neighbours only.
      search_(parts_, laws_, size_, 0.05 * typical_width(blocks_),
              ContactSearch::reach_per_move * scene.analysis.max_displacement_ratio * size_) {
  const std::size_t n = blocks_.size();
  if (scene.analysis.kind == scene::AnalysisKind::at_rest) loads_.start_base();
  scheme_.damps = scene.analysis.kind == scene::AnalysisKind::dynamic;
  states_.resize(n);
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    if (blocks_[b].fixed) continue;
    states_[b].velocity.head<2>() = scene.blocks[b].initial_velocity_m_per_s;
    states_[b].velocity[2] = scene.blocks[b].initial_spin_deg_per_s * std::numbers::pi / 180;
    const Placement placement(blocks_[b].centroid, Vector6::Zero());
    for (const int part : parts_.triangles[b]) {
      const Block& triangle = blocks_[static_cast<std::size_t>(part)];
      for (int i = 0; i < 3; ++i) {
        const Point X = triangle.centroid + triangle.vertices[static_cast<std::size_t>(i)] - blocks_[b].centroid;
        states_[static_cast<std::size_t>(part)].velocity.segment<2>(2 * i) = placement.shape(X) * states_[b].velocity;
      }
    }
  }
  for (const Block& block : blocks_) {
    start_.emplace_back(block.centroid, Vector6::Zero());
    frozen_.push_back(block.fixed || block.meshed);
  }
  node_increment_.resize(static_cast<std::size_t>(parts_.nodes));
  matrix_.resize(n);
  external_.resize(n);
  history_.resize(n);
  past_velocity_.assign(n, Vector6::Zero());
  began_with_.assign(n, Vector6::Zero());
  for_motion_.assign(n, 0);
  increment_.assign(n, Vector6::Zero());
  still_ = increment_;
  placement_ = start_;
  balance_.assign(n, Vector6::Zero());
  round_off_.resize(n);
  local_.resize(n);
  for (const scene::Bolt& bolt : scene.bolts) bolts_.push_back(make_bolt(bolt, parts_));
  search_.update(start_, contacts_);
  if (search_.rounds_to(take_out_rounding())) {
    contacts_.clear();
    search_.update(start_, contacts_);
    take_out_rounding();
  }
  if (scene.contact.formulation == scene::ContactFormulation::lagrange_multiplier) {
    substitute_ = make_augmented_lagrangian(laws_, formulation_->settings());
  }
  bond_touching_contacts();
  const std::vector<bool> rigid = rigid_blocks(scene, blocks_, contacts_);
  for (std::size_t b = 0; b < n; ++b) blocks_[b].rigid = rigid[b];
}

/// After states have been read from a checkpoint.
void Solid::follow_states(std::vector<KeptFactors> kept) {
  if (states_.size() != blocks_.size()) throw std::runtime_error("a checkpoint of another number of blocks");
  for (std::size_t b = 0; b < blocks_.size(); ++b) start_[b] = Placement(blocks_[b].centroid, states_[b].displacement);
  matrices_dt_ = -1;
  islands_.clear();
  kept_ = std::move(kept);
}

std::vector<KeptFactors> Solid::kept_factors() const {
  if (!scene_.analysis.reuse_factors) return {};
  if (islands_.empty()) return kept_;
  std::vector<KeptFactors> kept;
  for (const IslandSystem& s : islands_) kept.push_back(s.system->kept_factors());
  return kept;
}

/// Overlaps that the scene's check lets pass, and gaps as narrow, are rounded coordinates: the contact's gap counts
/// from there, or what has only been written down would be under pressure. Returns the largest.
double Solid::take_out_rounding() {
  double largest_m = 0;
  for (ContactPoint& c : contacts_) {
    if (c.gap < -deepest_rounding * size_ || c.gap > widest_rounding * size_) continue;
    largest_m = std::max(largest_m, std::abs(c.gap));
    c.gap_at_start = std::exchange(c.gap, 0);
    c.separation.setZero();
    c.state = ContactState::stick;
  }
  return largest_m;
}

/// Blocks that touch in the scene's outline are joined by a bond, with its strength and its peak friction.
void Solid::bond_touching_contacts() {
  for (ContactPoint& c : contacts_) {
    if (c.state == ContactState::open) continue;
    c.bond = 1;
  }
  for (auto first = contacts_.begin(), end = first; first != contacts_.end(); first = end) {  // contacts of a joint
    double whole = 0;
    for (end = first; end != contacts_.end() && end->pair() == first->pair(); ++end) whole += end->bond * end->length;
    for (auto c = first; c != end; ++c) {
      if (!c->bonded()) continue;
      const double bonded = laws_[c->law].bonded_length_m;
      c->bond_length = bonded < 0 || whole == 0 ? c->length : c->length * std::min(1.0, bonded / whole);
    }
  }
}

Counts Solid::counts() const {
  Counts counts = counts_;
  counts.state_changes = formulation_->state_changes();
  counts.broad_searches = search_.broad_searches();
  return counts;
}

double Solid::largest_displacement_m() const {
  double largest = 0;
  const Point base = base_.displacement(time_s_);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].fixed || blocks_[b].meshed) continue;
    for (const Point& X : blocks_[b].vertices) {
      largest = std::max(largest, (start_[b].displacement(X) - base).norm());
    }
  }
  return largest;
}

}  // namespace blockweir::solid
