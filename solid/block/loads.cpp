// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/loads.hpp"

#include <algorithm>
#include <limits>

#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

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

Loads::Loads(const scene::Scene& scene, const MovingParts& parts) : parts_(parts), scene_(scene), base_(scene) {
  for (const Block& block : parts.blocks) {
    constant_.emplace_back(Vector6::Zero());
    constant_.back().head<2>() = block.mass_per_m() * scene.analysis.gravity();
    constant_.back().tail<3>() = -block.area * block.initial_stress;
  }
  for (const auto& load : scene.point_loads) {
    points_.push_back({parts.anchor(load.block, load.point_m), &load});
  }
  for (const auto& load : scene.face_pressures) {
    const Block& block = parts.blocks[at(load.block)];
    faces_.push_back(
        {panel_between(block, load.block, load.from_m - block.centroid, load.to_m - block.centroid), &load});
  }
  for (const auto& load : scene.line_loads) {
    const Block& block = parts.blocks[at(load.block)];
    lines_.push_back(
        {panel_between(block, load.block, load.from_m - block.centroid, load.to_m - block.centroid), &load});
  }
}

void Loads::evaluate(const scene::TimeSpan& step, const std::vector<Panel>& water,
                     const std::vector<Placement>& placements, std::vector<Vector6>& forces, bool base_moves) const {
  forces = constant_;
  std::vector<Panel> pieces;
  const auto add_panel = [&](const Panel& whole, scene::NodalRule rule) {
    pieces.clear();
    parts_.split(whole, pieces);
    for (const Panel& panel : pieces) {
      const Placement& placement = placements[at(panel.block)];
      const PanelForce acting = panel_force(parts_.blocks[at(panel.block)], placement, panel, rule);
      forces[at(panel.block)] += generalized_force(placement, acting);
    }
  };
  for (const PointForce& point : points_) {
    const Point force(point.load->force_x_n_per_m.at(step), point.load->force_y_n_per_m.at(step));
    forces[at(point.at.part)] += placements[at(point.at.part)].shape(point.at.material).transpose() * force;
  }
  for (const Face& face : faces_) {
    Panel panel = face.panel;
    panel.pressure_from_pa = face.load->pressure_from_pa.at(step);
    panel.pressure_to_pa = face.load->pressure_to_pa.at(step);
    // A panel runs along its edge; stated the other way round, its length would point the traction outward.
    if (panel.s_from > panel.s_to) {
      std::swap(panel.s_from, panel.s_to);
      std::swap(panel.pressure_from_pa, panel.pressure_to_pa);
    }
    add_panel(panel, scene::NodalRule::consistent);
  }
  for (const Panel& panel : water) add_panel(panel, scene_.water.nodal_rule);
  add_lines(step, placements, forces);
  add_bodies(step, forces);
  if (base_moves) add_base(step, forces);
}

/// In each component f_i = L (2 q_i + q_j)/6, L as the scene draws it.
void Loads::add_lines(const scene::TimeSpan& step, const std::vector<Placement>& placements,
                      std::vector<Vector6>& forces) const {
  std::vector<Panel> pieces;
  for (const Line& line : lines_) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      Panel whole = line.panel;
      whole.pressure_from_pa = line.load->force_from_n_per_m2[axis].at(step);
      whole.pressure_to_pa = line.load->force_to_n_per_m2[axis].at(step);
      if (whole.s_from > whole.s_to) {
        std::swap(whole.s_from, whole.s_to);
        std::swap(whole.pressure_from_pa, whole.pressure_to_pa);
      }
      pieces.clear();
      parts_.split(whole, pieces);
      for (const Panel& piece : pieces) {
        const Placement& placement = placements[at(piece.block)];
        auto acting = panel_force(parts_.blocks[at(piece.block)], placement, piece, scene::NodalRule::consistent);
        const double length = (acting.node[1] - acting.node[0]).norm();
        const auto component =
            nodal_forces(scene::NodalRule::consistent, length, piece.pressure_from_pa, piece.pressure_to_pa);
        for (std::size_t i = 0; i < 2; ++i)
          acting.force[i] = component[i] * Point::Unit(static_cast<Eigen::Index>(axis));
        forces[at(piece.block)] += generalized_force(placement, acting);
      }
    }
  }
}

/// A uniform force on the volume acts at the centroid and strains nothing.
void Loads::add_bodies(const scene::TimeSpan& step, std::vector<Vector6>& forces) const {
  const auto add = [&](int part, const scene::BodyLoad& load, const Point& value) {
    const Block& block = parts_.blocks[at(part)];
    forces[at(part)].head<2>() += (load.per_mass ? block.mass_per_m() : block.area) * value;
  };
  for (const auto& load : scene_.body_loads) {
    const Point value(load.value[0].at(step), load.value[1].at(step));
    for (const int b : load.blocks) {
      add(b, load, value);
      for (const int triangle : parts_.triangles[at(b)]) add(triangle, load, value);
    }
  }
}

void Loads::add_base(const scene::TimeSpan& step, std::vector<Vector6>& forces) const {
  const Point inertia = base_.inertia(step);
  if (inertia.isZero(0)) return;
  for (std::size_t b = 0; b < forces.size(); ++b) forces[b].head<2>() -= parts_.blocks[b].mass_per_m() * inertia;
}

}  // namespace blockweir::solid
