// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/hydrostatic_model.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/results/saving.hpp"
#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/block_facts.hpp"
#include "bridge/scene/hydrostatics.hpp"
#include "bridge/scene/standing_groups.hpp"
#include "bridge/statics/loads.hpp"
#include "bridge/wire/panels.hpp"
#include "bridge/wire/placement.hpp"
#include "fluid/hydrostatic/crack_elements.hpp"
#include "fluid/hydrostatic/reservoir_loads.hpp"
#include "fluid/hydrostatic/shaken_cracks.hpp"

namespace blockweir::hydrostatic {
namespace {

double level_at(const std::optional<scene::TimeTable>& table, double time_s) {
  return table ? table->at(time_s) : std::numeric_limits<double>::quiet_NaN();
}

double level_stands_until(const scene::Water& w, double time_s) {
  double until = std::numeric_limits<double>::infinity();
  for (const auto* level : {&w.upstream_level_m, &w.downstream_level_m}) {
    if (*level) until = std::min(until, (*level)->constant_until(time_s));
  }
  return until;
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// Blocks grow by half of the width on a grid of some 1e-15 of the model.
void check_width(const scene::Scene& scene) {
  constexpr double least_ratio = 1e-10;
  Extent model;
  for (const scene::Block& block : scene.blocks) {
    for (const Point& p : block.vertices) model.extend(p);
  }
  if (model.isEmpty() || scene.water.open_crack_width_m >= least_ratio * model.sizes().maxCoeff()) return;
  throw std::invalid_argument(fmt::format(
      "open_crack_width_m of [water] is {} m in a model of {} m; expected at least {:.1g} m, 1e-10 of the model; widen "
      "it, or leave it out",
      scene.water.open_crack_width_m, model.sizes().maxCoeff(), least_ratio * model.sizes().maxCoeff()));
}

/// An end of the model at which the bed's corner `end` keeps the water off.
std::string dry_end(const scene::Scene& scene, const char* side, const scene::BedCorner& end) {
  const double bed_m = scene.blocks[at(end.block)].vertices[at(end.vertex)].y();
  return fmt::format(
      "water on the model's {} end below {} m: a dry cut through ground that continues ([water] wets_ends = true wets "
      "it)",
      side, bed_m);
}

}  // namespace

HydrostaticModel::HydrostaticModel(const scene::Scene& scene)
    : scene_(scene),
      cracks_(scene::find_cracks(scene)),
      crack_pools_(scene, cracks_),
      crack_ends_(scene, cracks_),
      crack_meetings_(scene, cracks_),
      flow_(scene, joints::ground_cut(scene)) {
  for (std::size_t k = 0; k < cracks_.size(); ++k) {
    if (cracks_[k].law == scene::Uplift::cracked) parted_.emplace(k, joints::Parted(scene, cracks_[k]));
  }
  if (scene.water.uplift_in_shaking == scene::ShakenUplift::zero_where_open) shaking_ends_s_ = shaking_ends_s(scene);
  structure_.open_crack_width_m = scene.water.open_crack_width_m;
  check_width(scene);
  structure_.ground = scene::find_ground_ends(scene);
  structure_.floats = scene::lowest_floats(scene);
  structure_.retaining = scene::retaining_blocks(scene.blocks);
  for (const scene::Block& block : scene.blocks) {
    centroids_.push_back(geometry::centroid(block.vertices));
    structure_.outlines.push_back(block.vertices);
  }
  crest_drawn_m_ = crest_m(structure_);
}

void HydrostaticModel::advance(const wire::Motion& motion, double to_s, wire::Load& load) {
  if (motion.displacement.size() != scene_.blocks.size()) {
    throw std::runtime_error(fmt::format(
        "received the positions of {} blocks, but the scene has {}; start both processes with the same scene",
        motion.displacement.size(), scene_.blocks.size()));
  }
  const double upstream = level_at(scene_.water.upstream_level_m, to_s);
  const double downstream = level_at(scene_.water.downstream_level_m, to_s);
  const bool moved = fresh_ || motion.displacement != last_motion_.displacement || !scene_.water.skip_unchanged;
  load.holds_until_s = level_stands_until(scene_.water, to_s);
  const bool loads_changed = !parted_.empty() && statics::stated_loads_hold_until(scene_, last_s_) < to_s;
  if (!parted_.empty()) {
    load.holds_until_s = std::min(load.holds_until_s, statics::stated_loads_hold_until(scene_, to_s));
  }
  const bool shakes = to_s < shaking_ends_s_;
  if (shakes) load.holds_until_s = std::min(load.holds_until_s, shaking_ends_s_);
  const bool came_to_rest = !shakes && last_s_ < shaking_ends_s_;
  if (flow_.changes_by_itself()) load.holds_until_s = to_s;
  const bool changed = moved || loads_changed || came_to_rest || flow_.changes_by_itself();
  if (!changed && same(upstream, last_upstream_m_) && same(downstream, last_downstream_m_)) {
    ++unchanged_;
    return;
  }
  const Stopwatch watch(update_s_);
  if (moved) pools_.blocks_moved();
  fresh_ = false;
  ++updates_;
  last_motion_.displacement = motion.displacement;
  last_upstream_m_ = upstream;
  last_downstream_m_ = downstream;
  press(to_s, moved, Flow::solve, load);
}

/// On blocks where they were told to be last.
void HydrostaticModel::press(double to_s, bool moved, Flow flow, wire::Load& load) {
  last_s_ = to_s;
  place(last_motion_);
  wire::clear_panels(load);
  sections_.clear();
  load.upstream_level_m = last_upstream_m_;
  load.downstream_level_m = last_downstream_m_;
  const double ground_m = ground_displacement().y();
  structure_.crest_drawn_m = crest_drawn_m_ + ground_m;
  const Pools::State water =
      pools_.find(structure_, last_upstream_m_ + ground_m, last_downstream_m_ + ground_m, scene_.water.crest_pressure);
  load.breached = water.breached;
  bodies_ = water.bodies;
  for (const WaterBody& body : bodies_) add_body(body, load);
  const std::size_t open_panels = load.block.size();
  if (!std::isnan(last_upstream_m_)) add_reservoir_loads(scene_, structure_.outlines, water.bodies, load);
  add_cracks(water.bodies, to_s, load);
  if (flow_.empty()) return;
  const Point ground = ground_displacement();
  if (flow == Flow::solve)
    flow_.advance(structure_.outlines, ground, moved, to_s, open_panels, load);
  else
    flow_.repeat(structure_.outlines, ground, open_panels, load);
}

/// Ground that moves as a support takes its water along: levels count from where the scene draws it.
Point HydrostaticModel::ground_displacement() const {
  if (!scene_.base_motion || scene_.base_motion->form != scene::BaseForm::support) return Point::Zero();
  const auto ground = std::find_if(scene_.blocks.begin(), scene_.blocks.end(), [](const auto& b) { return b.fixed; });
  if (ground == scene_.blocks.end()) return Point::Zero();
  const auto& displacement = last_motion_.displacement[static_cast<std::size_t>(ground - scene_.blocks.begin())];
  return {displacement[0], displacement[1]};
}

std::string HydrostaticModel::state() const {
  return checkpoint::pack(last_motion_.displacement, last_upstream_m_, last_downstream_m_, last_s_, fresh_, updates_,
                          unchanged_, flow_.state());
}

void HydrostaticModel::restore(const std::string& state) {
  std::string flow;
  checkpoint::unpack(state, last_motion_.displacement, last_upstream_m_, last_downstream_m_, last_s_, fresh_, updates_,
                     unchanged_, flow);
  flow_.restore(flow);
  wire::Load again;
  if (!fresh_) press(last_s_, /*moved=*/true, Flow::repeat, again);
}

schedule::FluidReport HydrostaticModel::report() const {
  schedule::FluidReport report{{{"mapping", placing_s_ + pools_.search_s()}},
                               {{"updates", updates_}, {"unchanged", unchanged_}}};
  if (unchanged_ > 0) {
    report.skips.push_back(fmt::format("pressures of {} of {} windows: neither a level nor a block had moved{}",
                                       unchanged_, unchanged_ + updates_,
                                       results::saved(update_s_, updates_, unchanged_)));
  }
  if (const long kept = pools_.repeats(); kept > 0) {
    report.skips.push_back(fmt::format("wet faces of a pool, {} of {} times: neither its level nor a block had moved{}",
                                       kept, kept + pools_.searches(),
                                       results::saved(pools_.search_s(), pools_.searches(), kept)));
  }
  if (scene_.water.elements_per_face == 1 && scene_.water.nodal_rule == scene::NodalRule::consistent) {
    report.skips.emplace_back(
        "all but one pressure element of a face: consistent forces of a linear pressure need no more");
  }
  const scene::GroundEnds& ground = structure_.ground;
  if (ground.left && scene_.water.upstream_level_m) report.skips.push_back(dry_end(scene_, "left", *ground.left));
  if (ground.right && scene_.water.downstream_level_m) report.skips.push_back(dry_end(scene_, "right", *ground.right));
  if (scene_.water.earthquake_coefficient != 0 && scene_.water.added_water == scene::AddedWater::westergaard) {
    report.skips.emplace_back(
        "the reservoir's answer to the earthquake: its added pressure is Westergaard's, 7/8 k_h rho g sqrt(H z) |n_x|");
  }
  for (const std::string& warning : {crack_ends_.warning(), crack_meetings_.warning()}) {
    if (!warning.empty()) report.warnings.push_back(warning);
  }
  if (const long kept = flow_.solver().kept(); kept > 0) {
    report.skips.push_back(
        fmt::format("factors of the flow through joints, {} of {} times: apertures had changed little", kept,
                    kept + flow_.solver().factorizations()));
  }
  for (const std::string& warning : flow_.warnings()) report.warnings.push_back(warning);
  if (!scene_.output.reservoir) report.skips.emplace_back("the reservoir's mesh: its pictures are not asked for");
  return report;
}

void HydrostaticModel::place(const wire::Motion& motion) {
  const Stopwatch watch(placing_s_);
  for (std::size_t b = 0; b < structure_.outlines.size(); ++b) {
    const auto& vertices = scene_.blocks[b].vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      structure_.outlines[b][v] = wire::place(centroids_[b], motion.displacement[b], vertices[v]);
    }
  }
}

void HydrostaticModel::add_body(const WaterBody& body, wire::Load& load) {
  const scene::Water& w = scene_.water;
  add_wet_elements(structure_.outlines, body.wet->intervals, scene_, body.surface, w.elements_per_face, load);
  if (!scene_.output.reservoir || body.wet->region.empty()) return;
  PoolSection& section =
      sections_.emplace_back(PoolSection{scene::on_wet_faces(scene_, body.surface.from_m.y()), body.wet->region, {}});
  wire::Load drawn;
  add_wet_elements(structure_.outlines, body.wet->intervals, scene_, body.surface, elements_drawn(w), drawn);
  for (std::size_t i = 0; i < drawn.block.size(); ++i) {
    const auto& outline = structure_.outlines[drawn.block[i]];
    const Point& a = outline[drawn.edge[i]];
    const Point span = outline[(drawn.edge[i] + 1) % outline.size()] - a;
    section.interface.push_back({a + drawn.s_from[i] * span, a + drawn.s_to[i] * span});
  }
}

joints::Joint HydrostaticModel::opened(std::size_t crack, const joints::Joint& joint, double to_s,
                                       const statics::Wrenches& open_water) const {
  statics::Wrenches loads = statics::combined(statics::weights_of(scene_), 1, statics::stated_loads_of(scene_, to_s));
  loads = statics::combined(std::move(loads), 1, statics::prestress_of(scene_));
  loads = statics::combined(std::move(loads), 1, open_water);
  return joints::opened(cracks_[crack].law, cracks_[crack].known, joint, parted_.at(crack).thrust(loads));
}

bool HydrostaticModel::stands_as_drawn() const {
  const Point ground_m = ground_displacement();
  for (std::size_t b = 0; b < structure_.outlines.size(); ++b) {
    const auto& drawn = scene_.blocks[b].vertices;
    for (std::size_t v = 0; v < drawn.size(); ++v) {
      const Point moved = structure_.outlines[b][v] - drawn[v] - ground_m;
      if (moved.norm() > scene_.water.open_crack_width_m) return false;
    }
  }
  return true;
}

void HydrostaticModel::add_cracks(const std::vector<WaterBody>& open, double to_s, wire::Load& load) {
  load.cracks_from = static_cast<std::uint32_t>(load.block.size());
  if (cracks_.empty()) return;
  const std::vector<WetInterval> open_water = wet_intervals(open);
  const statics::Wrenches forces = parted_.empty() ? statics::Wrenches() : statics::water_forces(scene_, load);
  const Point ground_m = ground_displacement();
  const bool as_drawn = stands_as_drawn();
  std::vector<joints::Profile> profiles;
  for (std::size_t k = 0; k < cracks_.size(); ++k) {
    const scene::Crack& crack = cracks_[k];
    const auto end_of = [&](bool upstream, const scene::CrackPart& part, const Point& outline_point) {
      const auto b = at(part.block_a);
      const Point place = wire::place(centroids_[b], last_motion_.displacement[b], outline_point);
      // If no open water reaches the end, the water of its side is assumed to, by a way that is not drawn.
      const double side_m = (upstream ? last_upstream_m_ : last_downstream_m_) + ground_m.y();
      const double level_m = crack_pools_.level(k, upstream, place, side_m, open, structure_.outlines).value_or(side_m);
      const double pressure_pa = scene::in_joints(scene_, level_m).pressure(place.y());
      if (as_drawn) crack_ends_.look(k, {upstream, place, pressure_pa}, structure_.outlines, open_water);
      return joints::End{pressure_pa, place.y()};
    };
    joints::Joint joint{.mouth = end_of(true, crack.parts.front(), crack.mouth()),
                        .end = end_of(false, crack.parts.back(), crack.end()),
                        .length_m = crack.length_m,
                        .water_n_per_m3 = scene::unit_weight_of_water(scene_),
                        .bends = crack.bends};
    if (parted_.contains(k)) joint = opened(k, joint, to_s, forces);
    const std::size_t first = load.block.size();
    const bool empties = to_s < shaking_ends_s_;
    profiles.push_back(joints::uplift(crack.law, crack.known, joint));
    add_crack_elements(crack, profiles.back(), empties ? elements_drawn(scene_.water) : scene_.water.elements_per_face,
                       structure_.outlines, open_water, load);
    if (empties) empty_open_panels(scene_, crack, centroids_, last_motion_, first, load);
  }
  if (as_drawn) crack_meetings_.look(profiles);
}

}  // namespace blockweir::hydrostatic
