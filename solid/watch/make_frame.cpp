// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/watch/make_frame.hpp"

#include <fmt/format.h>

#include "bridge/scene/at.hpp"
#include "bridge/schedule/load_fault.hpp"
#include "solid/watch/energy.hpp"
#include "solid/watch/stress_field.hpp"

namespace blockweir::solid {
namespace {

void capture_block(const Solid& solid, std::size_t b, BlockRow& row) {
  const Block& block = solid.blocks()[b];
  const BlockState& state = solid.states()[b];
  const Placement& placement = solid.placements()[b];
  row.fixed = block.fixed;
  row.vertices_m.clear();
  row.displacement_m.clear();
  row.velocity_m_per_s.clear();
  for (const OutlineSide& side : solid.parts().outlines[b]) {
    const auto part = at(side.part);
    const Point& X = solid.parts().vertex(side);
    row.vertices_m.push_back(solid.placements()[part].position(X));
    row.displacement_m.push_back(row.vertices_m.back() - solid.blocks()[part].centroid - X);
    row.velocity_m_per_s.emplace_back(solid.placements()[part].shape(X) * solid.velocity(part));
  }
  row.centroid_m = placement.centre();
  row.centroid_displacement_m = state.displacement.head<2>();
  row.centroid_velocity_m_per_s = state.velocity.head<2>();
  row.rotation_rad = state.displacement[2];
  row.rotation_rate_rad_per_s = state.velocity[2];
  const Eigen::Vector3d s = stress_in_block(block, state.displacement);
  Eigen::Matrix2d local;
  local << s[0], s[2], s[2], s[1];
  Eigen::Matrix2d turn;
  turn << placement.turn({1, 0}), placement.turn({0, 1});
  const Eigen::Matrix2d stress = turn * local * turn.transpose();
  row.stress_xx_pa = stress(0, 0);
  row.stress_yy_pa = stress(1, 1);
  row.stress_xy_pa = stress(0, 1);
  row.water_force_n_per_m.setZero();
  row.water_moment_n = 0;
}

MeshRow capture_mesh(const Solid& solid, std::size_t b) {
  const StressField field(solid, b);
  MeshRow row{.block = static_cast<int>(b),
              .nodes_m = field.places(),
              .displacement_m = field.places(),
              .stress_pa = field.at_nodes(),
              .triangles = field.triangles()};
  for (std::size_t n = 0; n < row.nodes_m.size(); ++n) row.displacement_m[n] -= field.nodes()[n];
  return row;
}

void capture_contact(const Solid& solid, const ContactPoint& c, ContactRow& row) {
  const Placement& edge_placement = solid.placements()[at(c.edge_part)];
  const Point a = edge_placement.position(c.edge_from);
  const Point b = edge_placement.position(c.edge_to);
  const Point t = (b - a).normalized();
  row.point_m = solid.state().place(c);
  row.normal = Point(t.y(), -t.x());
  row.vertex_block = c.vertex_block;
  row.edge_block = c.edge_block;
  row.joint = solid.laws()[c.law].joint;
  row.state = static_cast<int>(c.state);
  const JointProperties& law = solid.laws()[c.law];
  row.bonded_length_m = law.cohesion_pa > 0 || law.tension_pa > 0 ? c.bond * c.bond_length : 0;
  row.gap_m = row.normal.dot(row.point_m - a);
  row.slip_m = c.slip_m;
  row.normal_force_n_per_m = c.state == ContactState::open ? 0 : c.force.x();
  row.shear_force_n_per_m = c.state == ContactState::open ? 0 : c.force.y();
  row.length_m = c.length;
}

BoltRow bolt_row(const Solid& solid, const Bolt& bolt) {
  const auto end = [&](std::size_t i) -> Point {
    const int b = bolt.part[i];
    return b < 0 ? Point(bolt.material[i] + solid.model().base.displacement(solid.time_s()))
                 : solid.placements()[at(b)].position(bolt.material[i]);
  };
  return {.from_m = end(0),
          .to_m = end(1),
          .force_n_per_m = bolt.acting.tension_n_per_m,
          .elongation_m = bolt.elongation_m,
          .plastic_elongation_m = bolt.plastic_m,
          .state = static_cast<int>(bolt.acting.state)};
}

}  // namespace

std::vector<Panel> panels_of(const wire::Load& load, const Solid& solid) {
  std::vector<Panel> panels;
  panels.reserve(load.block.size());
  for (std::size_t i = 0; i < load.block.size(); ++i) {
    if (load.block[i] >= solid.described() || load.edge[i] >= solid.blocks()[load.block[i]].vertices.size()) {
      throw schedule::LoadFault(
          fmt::format("loads block {}, edge {}, which the scene does not have; give both sides one scene",
                      load.block[i], load.edge[i]));
    }
    panels.push_back({.block = static_cast<int>(load.block[i]),
                      .edge = static_cast<int>(load.edge[i]),
                      .s_from = load.s_from[i],
                      .s_to = load.s_to[i],
                      .pressure_from_pa = load.pressure_from_pa[i],
                      .pressure_to_pa = load.pressure_to_pa[i]});
  }
  return panels;
}

void make_frame(const Solid& solid, const wire::Load& load, const std::vector<Panel>& panels, double time_s,
                Frame& frame) {
  const auto& blocks = solid.blocks();
  frame.time_s = time_s;
  frame.upstream_level_m = load.upstream_level_m;
  frame.downstream_level_m = load.downstream_level_m;
  frame.largest_displacement_m = solid.largest_displacement_m();
  frame.base_displacement_m = solid.model().base.displacement(time_s);
  frame.base_acceleration_m_per_s2 = solid.model().base.acceleration(time_s);
  frame.blocks.resize(solid.described());
  for (std::size_t b = 0; b < frame.blocks.size(); ++b) capture_block(solid, b, frame.blocks[b]);
  const Energy energy = energy_of(solid);
  frame.kinetic_energy_j_per_m = energy.kinetic;
  frame.strain_energy_j_per_m = energy.strain;
  frame.potential_energy_j_per_m = energy.potential;
  frame.meshes.clear();
  for (std::size_t b = 0; b < frame.blocks.size(); ++b) {
    if (blocks[b].meshed) frame.meshes.push_back(capture_mesh(solid, b));
  }
  frame.contacts.resize(solid.contacts().size());
  for (std::size_t k = 0; k < frame.contacts.size(); ++k)
    capture_contact(solid, solid.contacts()[k], frame.contacts[k]);
  frame.bolts.clear();
  for (const Bolt& bolt : solid.bolts()) frame.bolts.push_back(bolt_row(solid, bolt));
  frame.panels.clear();
  std::vector<Panel> pieces;
  std::size_t described = 0;  // panels of the load so far
  for (const Panel& whole : panels) {
    pieces.clear();
    solid.parts().split(whole, pieces);
    for (const Panel& panel : pieces) {
      const Placement& placement = solid.placements()[at(panel.block)];
      const PanelForce acting = panel_force(blocks[at(panel.block)], placement, panel, solid.scene().water.nodal_rule);
      PanelRow row{.block = whole.block,
                   .from_m = placement.position(acting.node[0]),
                   .to_m = placement.position(acting.node[1]),
                   .pressure_from_pa = panel.pressure_from_pa,
                   .pressure_to_pa = panel.pressure_to_pa,
                   .in_crack = described >= load.cracks_from};
      BlockRow& block = frame.blocks[at(whole.block)];
      for (std::size_t i = 0; i < 2; ++i) {
        const Point& node = i == 0 ? row.from_m : row.to_m;
        block.water_force_n_per_m += acting.force[i];
        block.water_moment_n += node.x() * acting.force[i].y() - node.y() * acting.force[i].x();
      }
      frame.panels.push_back(row);
    }
    ++described;
  }
}

}  // namespace blockweir::solid
