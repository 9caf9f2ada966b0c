// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/loads.hpp"

#include <algorithm>
#include <limits>

namespace blockweir::solid {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// The edge that both points lie on (the scene's check has seen that there is one), as a panel without pressure.
Panel panel_between(const Block& block, int index, const Point& from, const Point& to) {
  Panel best{.block = index};
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < block.vertices.size(); ++e) {
    const Point& a = block.vertices[e];
    const Point span = block.vertices[(e + 1) % block.vertices.size()] - a;
    const auto along = [&](const Point& p) { return span.dot(p - a) / span.squaredNorm(); };
    const double sf = along(from);
    const double st = along(to);
    const double distance = (a + sf * span - from).norm() + (a + st * span - to).norm();
    const double outside = std::max({0.0, -std::min(sf, st), std::max(sf, st) - 1}) * span.norm();
    if (distance + outside >= best_distance) continue;
    best_distance = distance + outside;
    best.edge = static_cast<int>(e);
    best.s_from = sf;
    best.s_to = st;
  }
  return best;
}

}  // namespace

Loads::Loads(const scene::Scene& scene, const std::vector<Block>& blocks)
    : blocks_(blocks), rule_(scene.water.nodal_rule) {
  for (const Block& block : blocks) {
    weight_.emplace_back(Vector6::Zero());
    weight_.back().head<2>() = block.mass_per_m() * scene.analysis.gravity();
  }
  for (const auto& load : scene.point_loads) {
    points_.push_back({load.block, load.point_m - blocks[at(load.block)].centroid, &load});
  }
  for (const auto& load : scene.face_pressures) {
    const Block& block = blocks[at(load.block)];
    faces_.push_back(
        {panel_between(block, load.block, load.from_m - block.centroid, load.to_m - block.centroid), &load});
  }
}

void Loads::evaluate(double time_s, const std::vector<Panel>& water, const std::vector<Placement>& placements,
                     std::vector<Vector6>& forces) const {
  forces = weight_;
  const auto add_panel = [&](const Panel& panel) {
    const Placement& placement = placements[at(panel.block)];
    const PanelForce acting = panel_force(blocks_[at(panel.block)], placement, panel, rule_);
    forces[at(panel.block)] += generalized_force(placement, acting);
  };
  for (const PointForce& point : points_) {
    const Point force(point.load->force_x_n_per_m.at(time_s), point.load->force_y_n_per_m.at(time_s));
    forces[at(point.block)] += placements[at(point.block)].shape(point.material).transpose() * force;
  }
  for (const Face& face : faces_) {
    Panel panel = face.panel;
    panel.pressure_from_pa = face.load->pressure_from_pa.at(time_s);
    panel.pressure_to_pa = face.load->pressure_to_pa.at(time_s);
    // A panel runs along its edge; stated the other way round, its length would point the traction outward.
    if (panel.s_from > panel.s_to) {
      std::swap(panel.s_from, panel.s_to);
      std::swap(panel.pressure_from_pa, panel.pressure_to_pa);
    }
    add_panel(panel);
  }
  for (const Panel& panel : water) add_panel(panel);
}

}  // namespace blockweir::solid
