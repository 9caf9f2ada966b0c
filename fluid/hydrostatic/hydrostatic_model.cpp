// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/hydrostatic/hydrostatic_model.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/results/saving.hpp"
#include "bridge/results/stopwatch.hpp"
#include "bridge/scene/at.hpp"
#include "bridge/scene/polygon.hpp"
#include "bridge/wire/panels.hpp"
#include "bridge/wire/placement.hpp"

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

}  // namespace

HydrostaticModel::HydrostaticModel(const scene::Scene& scene) : scene_(scene), cracks_(find_cracks(scene)) {
  for (const scene::Block& block : scene.blocks) {
    centroids_.push_back(scene::centroid(block.vertices));
    outlines_.push_back(block.vertices);
  }
}

void HydrostaticModel::advance(const wire::Motion& motion, double to_s, wire::Load& load) {
  if (motion.displacement.size() != scene_.blocks.size()) {
    throw std::runtime_error(
        fmt::format("positions of {} blocks came, the scene has {}", motion.displacement.size(), scene_.blocks.size()));
  }
  const double upstream = level_at(scene_.water.upstream_level_m, to_s);
  const double downstream = level_at(scene_.water.downstream_level_m, to_s);
  const bool moved = fresh_ || motion.displacement != last_motion_.displacement || !scene_.water.skip_unchanged;
  load.holds_until_s = level_stands_until(scene_.water, to_s);
  if (!moved && same(upstream, last_upstream_m_) && same(downstream, last_downstream_m_)) {
    ++unchanged_;
    return;
  }
  const Stopwatch watch(update_s_);
  if (moved) wetted_ = {};
  fresh_ = false;
  ++updates_;
  last_motion_.displacement = motion.displacement;
  last_upstream_m_ = upstream;
  last_downstream_m_ = downstream;
  press(load);
}

/// On blocks where they were told to be last.
void HydrostaticModel::press(wire::Load& load) {
  place(last_motion_);
  wire::clear_panels(load);
  pools_.clear();
  load.upstream_level_m = last_upstream_m_;
  load.downstream_level_m = last_downstream_m_;
  if (!std::isnan(last_upstream_m_)) add_pool(Pool::upstream, last_upstream_m_, load);
  if (!std::isnan(last_downstream_m_)) add_pool(Pool::downstream, last_downstream_m_, load);
  add_cracks(last_upstream_m_, last_downstream_m_, load);
}

std::string HydrostaticModel::state() const {
  return checkpoint::pack(last_motion_.displacement, last_upstream_m_, last_downstream_m_, fresh_, updates_,
                          unchanged_);
}

void HydrostaticModel::restore(const std::string& state) {
  checkpoint::unpack(state, last_motion_.displacement, last_upstream_m_, last_downstream_m_, fresh_, updates_,
                     unchanged_);
  wire::Load again;
  if (!fresh_) press(again);
}

schedule::FluidReport HydrostaticModel::report() const {
  schedule::FluidReport report{{{"mapping", mapping_s_}}, {{"updates", updates_}, {"unchanged", unchanged_}}};
  if (unchanged_ > 0) {
    report.skips.push_back(fmt::format("pressures of {} of {} windows: neither a level nor a block had moved{}",
                                       unchanged_, unchanged_ + updates_,
                                       results::saved(update_s_, updates_, unchanged_)));
  }
  if (kept_faces_ > 0) {
    report.skips.push_back(fmt::format("wet faces of a pool, {} of {} times: neither its level nor a block had moved{}",
                                       kept_faces_, kept_faces_ + wettings_,
                                       results::saved(mapping_s_, wettings_, kept_faces_)));
  }
  if (scene_.water.elements_per_face == 1 && scene_.water.nodal_rule == scene::NodalRule::consistent) {
    report.skips.emplace_back(
        "all but one pressure element of a face: consistent forces of a linear pressure need no more");
  }
  if (!scene_.output.reservoir) report.skips.emplace_back("the reservoir's mesh: its pictures are not asked for");
  return report;
}

const WetFaces& HydrostaticModel::wet_part(Pool pool, double level_m) {
  const std::size_t which = pool == Pool::upstream ? 0 : 1;
  std::optional<Wetted>& kept = wetted_[which];
  if (kept && kept->level_m == level_m) {
    ++kept_faces_;
    return kept->faces;
  }
  const Stopwatch watch(mapping_s_);
  ++wettings_;
  kept = Wetted{level_m, wet_faces(outlines_, pool, level_m, scene_.water.open_crack_width_m, behind_[which])};
  behind_[which] = kept->faces.behind;
  return kept->faces;
}

void HydrostaticModel::place(const wire::Motion& motion) {
  const Stopwatch watch(mapping_s_);
  for (std::size_t b = 0; b < outlines_.size(); ++b) {
    const auto& vertices = scene_.blocks[b].vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      outlines_[b][v] = wire::place(centroids_[b], motion.displacement[b], vertices[v]);
    }
  }
}

void HydrostaticModel::add_pool(Pool pool, double level_m, wire::Load& load) {
  const scene::Water& w = scene_.water;
  const WetFaces& wet = wet_part(pool, level_m);
  const Hydrostatics water{
      .weight_n_per_m3 = w.density_kg_per_m3 * scene_.analysis.gravity_m_per_s2,
      .atmosphere_pa = w.atmosphere == scene::Atmosphere::wet_faces ? w.atmospheric_pressure_pa : 0,
      .level_m = level_m};
  add_wet_elements(outlines_, wet.intervals, water, w.elements_per_face, load);
  load.breached = load.breached || wet.breached;
  if (!scene_.output.reservoir) return;
  PoolSection& section = pools_.emplace_back(PoolSection{water, wet.region, {}});
  wire::Load drawn;
  add_wet_elements(outlines_, wet.intervals, water, elements_drawn(w), drawn);
  for (std::size_t i = 0; i < drawn.block.size(); ++i) {
    const auto& outline = outlines_[drawn.block[i]];
    const Point& a = outline[drawn.edge[i]];
    const Point span = outline[(drawn.edge[i] + 1) % outline.size()] - a;
    section.interface.push_back({a + drawn.s_from[i] * span, a + drawn.s_to[i] * span});
  }
}

void HydrostaticModel::add_cracks(double upstream_m, double downstream_m, wire::Load& load) {
  load.cracks_from = static_cast<std::uint32_t>(load.block.size());
  const double weight = scene_.water.density_kg_per_m3 * scene_.analysis.gravity_m_per_s2;
  for (const Crack& crack : cracks_) {
    const auto pressure = [&](const CrackPart& part, const Point& outline_point, double level_m) {
      const auto b = at(part.block_a);
      const double y = wire::place(centroids_[b], last_motion_.displacement[b], outline_point).y();
      return std::isnan(level_m) ? 0.0 : weight * std::max(0.0, level_m - y);
    };
    const CrackPart& first = crack.parts.front();
    const CrackPart& last = crack.parts.back();
    add_crack_elements(crack, pressure(first, first.trace.mouth(), upstream_m),
                       pressure(last, last.trace.end(), downstream_m), load);
  }
}

}  // namespace blockweir::hydrostatic
