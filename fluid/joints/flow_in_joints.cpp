// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/flow_in_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/geometry/place_text.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/hydrostatics.hpp"
#include "bridge/scene/structure_size.hpp"

namespace blockweir::joints {
namespace {

WaterProperties properties(const scene::Scene& scene) {
  WaterProperties water;
  water.viscosity_pa_s = scene.joint_flow.viscosity_pa_s;
  water.weight_n_per_m3 = scene::unit_weight_of_water(scene);
  if (scene.joint_flow.bulk_modulus_pa) water.bulk_modulus_pa = *scene.joint_flow.bulk_modulus_pa;
  return water;
}

}  // namespace

FlowInJoints::FlowInJoints(const scene::Scene& scene, const GroundCut& ground, std::optional<double> open_m)
    : scene_(scene),
      water_(properties(scene)),
      joints_(scene, ground, open_m.value_or(scene.water.open_crack_width_m)),
      flow_(water_) {
  flow_.keep_factors(scene.analysis.reuse_factors);
}

bool FlowInJoints::changes_by_itself() const {
  return !empty() && scene_.joint_flow.kind == scene::FlowKind::transient;
}

OpenWater FlowInJoints::take_in(const std::vector<std::vector<Point>>& outlines, const Point& ground_m, bool moved,
                                std::size_t open_panels, const wire::Load& load) {
  const double atmosphere_pa =
      scene_.water.atmosphere == scene::Atmosphere::wet_faces ? scene_.water.atmospheric_pressure_pa : 0;
  OpenWater open(outlines, load, open_panels, water_.weight_n_per_m3, atmosphere_pa);
  if (moved || fresh_) joints_.follow(outlines, ground_m);
  joints_.fill(open);
  upstream_level_m_ = load.upstream_level_m;
  downstream_level_m_ = load.downstream_level_m;
  return open;
}

void FlowInJoints::advance(const std::vector<std::vector<Point>>& outlines, const Point& ground_m, bool moved,
                           double to_s, std::size_t open_panels, wire::Load& load) {
  const OpenWater open = take_in(outlines, ground_m, moved, open_panels, load);
  note_dry_mouths(outlines, load);
  solve(to_s, load);
  add_panels(open, load);
}

void FlowInJoints::repeat(const std::vector<std::vector<Point>>& outlines, const Point& ground_m,
                          std::size_t open_panels, wire::Load& load) {
  const OpenWater open = take_in(outlines, ground_m, true, open_panels, load);
  add_panels(open, load);
}

/// Mouths below their side's level that no open water reaches, as in a hollow: they count as in air.
void FlowInJoints::note_dry_mouths(const std::vector<std::vector<Point>>& outlines, const wire::Load& load) {
  const bool still = scene_.fluid != scene::FluidModel::openfoam;  // else water may leave a mouth for a moment
  if (!still) return;
  Point crest = outlines.front().front();
  for (const std::vector<Point>& outline : outlines) {
    for (const Point& p : outline) crest = p.y() > crest.y() ? p : crest;
  }
  const auto level_beside = [&](const Point& p) {
    return p.x() < crest.x() ? load.upstream_level_m : load.downstream_level_m;
  };
  std::vector<Point> dry;
  for (std::size_t i = 0; i < joints_.places().size(); ++i) {
    const Point& p = joints_.places()[i].at;
    const bool below = p.y() < level_beside(p) - scene_.water.open_crack_width_m;  // false where there is no pool
    if (joints_.network().nodes[i].kind == NodeKind::seeps && below) dry.push_back(p);
  }
  if (dry.size() <= dry_mouths_) return;
  dry_mouths_ = dry.size();
  const Point& first = dry.front();
  const std::string several = fmt::format("{} ends of joints with uplift = \"flow\" lie in air, the first", dry.size());
  dry_mouth_ = fmt::format(
      "{} at {} m, below the {} level, {:.4g} m: no open water reaches {}; expected ground that lets the pool come "
      "there; state another uplift where it is to have the pool's pressure all the same",
      dry.size() == 1 ? "a joint with uplift = \"flow\" ends in air" : several,
      geometry::place_text(first, scene::structure_size_m(scene_.blocks)),
      first.x() < crest.x() ? "upstream" : "downstream", level_beside(first), dry.size() == 1 ? "it" : "them");
}

void FlowInJoints::solve(double to_s, const wire::Load& load) {
  hold_drains();
  carry_over();
  const double step_s = to_s - time_s_;
  if (fresh_ || !changes_by_itself()) {
    solve_with_drains([&] { flow_.steady(joints_.network(), filling_); });
    stored_m2_ = flow_.stored(joints_.network(), filling_);
  } else if (step_s > 0) {
    const Filling before = filling_;
    const std::vector<double> stored_before = stored_m2_;
    const std::vector<double> yielding =
        TransientGuard::yields(scene_, joints_, flow_.stored(joints_.network(), filling_), stored_m2_, step_s);
    solve_with_drains([&] {
      filling_ = before;
      stored_m2_ = stored_before;
      flow_.step(joints_.network(), step_s, yielding, filling_, stored_m2_);
    });
    const FlowBalance now = balance();
    const double passed_m2 = step_s * (now.from_open_water + now.to_open_water + now.to_air);
    guard_.add({before, filling_, stored_before, stored_m2_}, yielding, passed_m2, step_s);
  }
  time_s_ = to_s;
  fresh_ = false;
  solved_at_.clear();
  for (const Place& place : joints_.places()) solved_at_.push_back(place.at);
  if (const FlowBalance now = balance(); now.largest > 0) {
    turbulence_.look(load, time_s_, now.largest * scene_.water.density_kg_per_m3 / water_.viscosity_pa_s,
                     joints_.name(joints_.stretches()[joints_.parts()[now.largest_channel].stretch]));
  }
  const auto& nodes = joints_.network().nodes;
  without_outlet_ = !nodes.empty() &&
                    std::none_of(nodes.begin(), nodes.end(), [](const Node& n) { return n.kind != NodeKind::inside; });
}

/// A drain has its head, or leaves a share of what the water would have above it.
void FlowInJoints::hold_drains() {
  Network& network = joints_.network();
  const auto& drains = scene_.joint_flow.drains;
  if (drains.empty()) return;
  const auto drain_of = [&](std::size_t node) { return drains[at(joints_.places()[node].drain)]; };
  Filling undrained;
  if (std::any_of(drains.begin(), drains.end(), [](const scene::DrainLine& d) { return d.efficiency < 1; })) {
    flow_.steady(network, undrained);
  }
  for (std::size_t i = 0; i < network.nodes.size(); ++i) {
    Node& node = network.nodes[i];
    if (joints_.places()[i].drain < 0 || node.kind != NodeKind::inside) continue;
    const scene::DrainLine& drain = drain_of(i);
    const double own = water_.weight_n_per_m3 * std::max(0.0, drain.head_m.value_or(node.height_m) - node.height_m);
    const double above = undrained.pressure_pa.empty() ? 0 : std::max(0.0, undrained.pressure_pa[i] - own);
    node.pressure_pa = own + (1 - drain.efficiency) * above;
    node.kind = NodeKind::held;
  }
}

void FlowInJoints::solve_with_drains(const std::function<void()>& solve) {
  constexpr int most = 10;
  for (int i = 0; i < most; ++i) {
    solve();
    if (!close_drains_that_supply()) return;
  }
}

/// Drains only remove water.
bool FlowInJoints::close_drains_that_supply() {
  Network& network = joints_.network();
  std::vector<double> supply(network.nodes.size(), 0.0);
  for (std::size_t c = 0; c < filling_.flow.size(); ++c) {
    supply[at(network.channels[c].from)] += filling_.flow[c];
    supply[at(network.channels[c].to)] -= filling_.flow[c];
  }
  constexpr double round_off = 1e-12;
  const double most = balance().largest;
  bool closed = false;
  for (std::size_t i = 0; i < supply.size(); ++i) {
    if (joints_.places()[i].drain < 0 || network.nodes[i].kind != NodeKind::held || joints_.places()[i].exposed)
      continue;
    if (supply[i] <= round_off * most) continue;
    network.nodes[i].kind = NodeKind::inside;
    closed = true;
  }
  return closed;
}

/// Transfers the known state from the previous nodes: each new node takes that of the nearest.
void FlowInJoints::carry_over() {
  const auto& places = joints_.places();
  const auto same = [&] {
    for (std::size_t i = 0; i < places.size(); ++i) {
      if ((places[i].at - solved_at_[i]).norm() > scene_.water.open_crack_width_m) return false;
    }
    return true;
  };
  if (fresh_ || (places.size() == solved_at_.size() && same())) return;
  const Filling before = filling_;
  filling_ = {};
  filling_.flow.assign(joints_.network().channels.size(), 0.0);
  filling_.to_air.assign(places.size(), 0.0);
  for (const Place& place : places) {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < solved_at_.size(); ++k) {
      if ((solved_at_[k] - place.at).squaredNorm() < (solved_at_[nearest] - place.at).squaredNorm()) nearest = k;
    }
    filling_.pressure_pa.push_back(solved_at_.empty() ? 0 : before.pressure_pa[nearest]);
    filling_.saturation.push_back(solved_at_.empty() ? 0 : before.saturation[nearest]);
  }
  stored_m2_ = flow_.stored(joints_.network(), filling_);
}

FlowBalance FlowInJoints::balance() const {
  FlowBalance sums;
  sums.to_drain.assign(scene_.joint_flow.drains.size(), 0.0);
  const Network& network = joints_.network();
  std::vector<double> out(network.nodes.size(), 0.0);
  for (std::size_t c = 0; c < filling_.flow.size(); ++c) {
    out[at(network.channels[c].from)] -= filling_.flow[c];
    out[at(network.channels[c].to)] += filling_.flow[c];
    if (std::abs(filling_.flow[c]) <= sums.largest || joints_.parts()[c].open) continue;
    sums.largest = std::abs(filling_.flow[c]);
    sums.largest_channel = c;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Place& place = joints_.places()[i];
    if (network.nodes[i].kind == NodeKind::inside) continue;
    if (place.drain >= 0 && !place.exposed)
      sums.to_drain[at(place.drain)] += out[i];
    else if (network.nodes[i].kind == NodeKind::seeps)
      sums.to_air += filling_.to_air[i];
    else
      (out[i] > 0 ? sums.to_open_water : sums.from_open_water) += std::abs(out[i]);
  }
  for (const double volume : stored_m2_) sums.stored += volume;
  return sums;
}

std::vector<std::string> FlowInJoints::warnings() const {
  std::vector<std::string> warnings;
  if (const std::string warning = turbulence_.warning(scene_); !warning.empty()) warnings.push_back(warning);
  if (const std::string warning = guard_.warning(); !warning.empty()) warnings.push_back(warning);
  if (!dry_mouth_.empty()) warnings.push_back(dry_mouth_);
  if (without_outlet_) {
    warnings.emplace_back(
        "joints with uplift = \"flow\" touch neither open water nor air: they are dry; lead one to a face");
  }
  return warnings;
}

std::string FlowInJoints::state() const {
  std::vector<double> x;
  std::vector<double> y;
  for (const Point& p : solved_at_) x.push_back(p.x()), y.push_back(p.y());
  return checkpoint::pack(filling_.pressure_pa, filling_.saturation, filling_.flow, filling_.to_air, stored_m2_, x, y,
                          time_s_, fresh_, turbulence_, guard_, without_outlet_, dry_mouths_, dry_mouth_,
                          flow_.state());
}

void FlowInJoints::restore(const std::string& state) {
  std::vector<double> x;
  std::vector<double> y;
  std::string factor;
  checkpoint::unpack(state, filling_.pressure_pa, filling_.saturation, filling_.flow, filling_.to_air, stored_m2_, x, y,
                     time_s_, fresh_, turbulence_, guard_, without_outlet_, dry_mouths_, dry_mouth_, factor);
  solved_at_.clear();
  for (std::size_t i = 0; i < x.size(); ++i) solved_at_.emplace_back(x[i], y[i]);
  flow_.restore(factor);
}

}  // namespace blockweir::joints
