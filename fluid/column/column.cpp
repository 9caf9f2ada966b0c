// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/column/column.hpp"

#include <fmt/format.h>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/geometry/polygon.hpp"
#include "bridge/wire/placement.hpp"
#include "bridge/wire/way_in_window.hpp"

namespace blockweir::column {
Column::Column(const scene::Scene& scene)
    : column_(scene.column),
      inertia_(scene.water.density_kg_per_m3 * column_.length_m),
      restoring_(scene.water.density_kg_per_m3 * scene::Column::gravity_m_per_s2 * column_.rise_ratio),
      head_pa_(scene.water.density_kg_per_m3 * scene::Column::gravity_m_per_s2 * column_.head_m),
      blocks_(scene.blocks.size()) {
  const auto& outline = scene.blocks[static_cast<std::size_t>(column_.block)].vertices;
  const auto edge = static_cast<std::size_t>(column_.edge);
  const Point& from = outline[edge];
  const Point& to = outline[(edge + 1) % outline.size()];
  centroid_ = geometry::centroid(outline);
  middle_ = (from + to) / 2;
  width_m_ = (to - from).norm();
  into_ = Point(to.y() - from.y(), from.x() - to.x()) / width_m_;
}

Column::Way Column::way(const wire::Motion& motion) const {
  const auto& d = motion.displacement[static_cast<std::size_t>(column_.block)];
  const auto& v = motion.velocity[static_cast<std::size_t>(column_.block)];
  const Point now = wire::place(centroid_, d, middle_);
  const Point arm = now - centroid_ - Point(d[0], d[1]);
  const Point rate(v[0] - v[2] * arm.y(), v[1] + v[2] * arm.x());
  return {into_.dot(now - middle_), into_.dot(rate)};
}

/// Backward differences of the edge's velocity, of first order.
double Column::without_cushion(const Way& end, double window_s) const {
  const double acceleration = window_s > 0 ? (end.v - edge_.v) / window_s : 0;
  return inertia_ * acceleration + restoring_ * end.x;
}

/// Trapezoidal rule in xi; the edge moves on the cubic that its places and velocities at both ends give.
double Column::with_cushion(const Way& end, double window_s) {
  const double stiffness = *column_.cushion_pa_per_m;
  const double total = stiffness + restoring_;
  const int steps = column_.steps_per_window;
  const double dt = window_s / steps;
  const double way = end.x - edge_.x;
  const double from = window_s * edge_.v;
  const double to = window_s * end.v;
  double before = edge_.x;
  for (int i = 1; i <= steps && dt > 0; ++i) {
    const double part = static_cast<double>(i) / steps;
    const double x = wire::way_in_window(edge_.x, way, from, to, part);
    const double push = stiffness * (before + x) / 2;
    const double half = dt / 2;
    const double v = (inertia_ * water_.v + dt * (push - total * (water_.x + half * water_.v / 2))) /
                     (inertia_ + total * half * half);
    water_.x += half * (water_.v + v);
    water_.v = v;
    before = x;
  }
  return stiffness * (end.x - water_.x);
}

void Column::advance(const wire::Motion& motion, double to_s, wire::Load& load) {
  if (motion.displacement.size() != blocks_) {
    throw std::runtime_error(fmt::format(
        "received the positions of {} blocks, but the scene has {}; start both processes with the same scene",
        motion.displacement.size(), blocks_));
  }
  const Way end = way(motion);
  const double window_s = to_s - time_s_;
  const double pressure =
      head_pa_ + (column_.cushion_pa_per_m ? with_cushion(end, window_s) : without_cushion(end, window_s));
  edge_ = end;
  time_s_ = to_s;
  load.block = {static_cast<std::uint32_t>(column_.block)};
  load.edge = {static_cast<std::uint32_t>(column_.edge)};
  load.s_from = {0};
  load.s_to = {1};
  load.pressure_from_pa = {pressure};
  load.pressure_to_pa = {pressure};
  load.cracks_from = 1;
  load.upstream_level_m = load.downstream_level_m = std::numeric_limits<double>::quiet_NaN();
  if (column_.cushion_pa_per_m) return;
  const double mass = inertia_ * width_m_;  // that the block feels at once
  load.added_mass.assign(blocks_, {});
  load.added_mass.own()[static_cast<std::size_t>(column_.block)] = {
      mass * into_.x() * into_.x(), mass * into_.x() * into_.y(), 0, mass * into_.y() * into_.y(), 0, 0};
}

std::string Column::state() const {
  return checkpoint::pack(edge_, water_, time_s_);
}

void Column::restore(const std::string& state) {
  checkpoint::unpack(state, edge_, water_, time_s_);
}

/// For blockweir-column; the folder for VTK files is not used.
std::unique_ptr<schedule::FluidSide> make(const scene::Scene& scene, const std::filesystem::path& /*folder*/) {
  return std::make_unique<Column>(scene);
}

}  // namespace blockweir::column
