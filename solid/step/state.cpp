// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/step/state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bridge/scene/at.hpp"
#include "bridge/scene/read/check.hpp"

namespace blockweir::solid {
namespace {

// Of half the structure's larger side: check_overlaps lets pieces pass whose area over their length is that share of a
// block's, wedges of twice that depth among them.
constexpr double widest_rounding = 2 * scene::rounding_ratio;
constexpr double deepest_rounding = 2 * widest_rounding;

std::vector<Support> make_supports(const Model& model) {
  std::vector<Support> supports;
  for (const auto& described : model.scene.supports) {
    const Anchor anchor = model.parts.anchor(described.block, described.point_m);
    Support support;
    support.share = model.is(scene::AnalysisKind::at_rest) ? 0 : 1;
    support.block = anchor.part;
    support.material = anchor.material;
    support.described = &described;
    supports.push_back(support);
  }
  return supports;
}

/// As the scene has them; of triangles, at their corners.
std::vector<BlockState> first_motions(const Model& model) {
  std::vector<BlockState> states(model.blocks.size());
  for (std::size_t b = 0; b < model.described(); ++b) {
    if (model.blocks[b].fixed) continue;
    states[b].velocity.head<2>() = model.scene.blocks[b].initial_velocity_m_per_s;
    states[b].velocity[2] = model.scene.blocks[b].initial_spin_deg_per_s * std::numbers::pi / 180;
    const Placement placement(model.blocks[b].centroid, Vector6::Zero());
    for (const int part : model.parts.triangles[b]) {
      const Block& triangle = model.blocks[at(part)];
      for (int i = 0; i < 3; ++i) {
        const Point X = triangle.centroid + triangle.vertices[at(i)] - model.blocks[b].centroid;
        states[at(part)].velocity.segment<2>(2 * i) = placement.shape(X) * states[b].velocity;
      }
    }
  }
  return states;
}

}  // namespace

State::State(Model& model)
    : next_dt(model.scene.analysis.step_s),
      sleep(model.blocks.size(), model.size_m),
      // A twentieth of a block's width is more than most steps move it, and meets neighbours only.
      search(model.parts, model.laws, model.size_m, 0.05 * model.typical_width_m(),
             ContactSearch::reach_per_move * model.scene.analysis.max_displacement_ratio * model.size_m) {
  blocks = first_motions(model);
  supports = make_supports(model);
  for (const scene::Bolt& bolt : model.scene.bolts) bolts.push_back(make_bolt(bolt, model.parts));
  for (const Block& block : model.blocks) placements.emplace_back(block.centroid, Vector6::Zero());
  search.update(placements, contacts);
  if (search.rounds_to(take_out_rounding(model))) {
    contacts.clear();
    search.update(placements, contacts);
    take_out_rounding(model);
  }
  bond_touching_contacts(model.laws);
  model.make_rigid(contacts);
  search.begin_motion(model.give_under_weight_m);
}

void State::restore(const Standing& before) {
  static_cast<Standing&>(*this) = before;
  contacts_stand = false;
  touched_before.reset();
}

void State::stop() {
  for (BlockState& state : blocks) state.velocity.setZero(), state.acceleration.setZero();
}

void State::place_blocks(const Model& model) {
  if (blocks.size() != model.blocks.size())
    throw std::runtime_error(
        "the checkpoint has another number of blocks than the scene; resume with the scene of the run that wrote it, "
        "or begin a new run");
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    placements[b] = Placement(model.blocks[b].centroid, blocks[b].displacement);
  }
}

long State::touching_contacts() const {
  return std::count_if(contacts.begin(), contacts.end(),
                       [](const ContactPoint& c) { return c.state != ContactState::open; });
}

/// Overlaps that the scene's check lets pass, and gaps as narrow, are rounded coordinates: the contact's gap counts
/// from there, or what has only been written down would be under pressure. Returns the largest.
double State::take_out_rounding(const Model& model) {
  double largest_m = 0;
  for (ContactPoint& c : contacts) {
    if (c.gap < -deepest_rounding * model.size_m || c.gap > widest_rounding * model.size_m) continue;
    largest_m = std::max(largest_m, std::abs(c.gap));
    c.gap_at_start = std::exchange(c.gap, 0);
    c.separation.setZero();
    c.state = ContactState::stick;
  }
  return largest_m;
}

/// Blocks that touch in the scene's outline are joined by a bond, with its strength and its peak friction.
void State::bond_touching_contacts(const JointLaws& laws) {
  for (ContactPoint& c : contacts) {
    if (c.state == ContactState::open) continue;
    c.bond = 1;
  }
  for (auto first = contacts.begin(), end = first; first != contacts.end(); first = end) {  // contacts of a joint
    double whole = 0;
    for (end = first; end != contacts.end() && end->pair() == first->pair(); ++end) whole += end->bond * end->length;
    for (auto c = first; c != end; ++c) {
      if (!c->bonded()) continue;
      const double bonded = laws[c->law].bonded_length_m;
      c->bond_length = bonded < 0 || whole == 0 ? c->length : c->length * std::min(1.0, bonded / whole);
    }
  }
}

double State::fastest_m_per_s() const {
  double fastest = 0;
  for (const BlockState& block : blocks) fastest = std::max(fastest, block.velocity.head<2>().norm());
  return fastest;
}

double State::largest_displacement_m(const Model& model) const {
  double largest = 0;
  const Point base = model.base.displacement(time_s);
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    if (model.blocks[b].fixed || model.blocks[b].meshed) continue;
    for (const Point& X : model.blocks[b].vertices) {
      largest = std::max(largest, (placements[b].displacement(X) - base).norm());
    }
  }
  return largest;
}

double State::largest_slip_m() const {
  double largest = 0;
  for (const ContactPoint& c : contacts) largest = std::max(largest, c.slip_path_m);
  return largest;
}

}  // namespace blockweir::solid
