// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/vtk_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::solid::output {
namespace {

using vtk::add_vector;
using vtk::Grid;

template <class Array>
void name_components(Array& stress) {
  stress.SetComponentName(0, "xx");
  stress.SetComponentName(1, "yy");
  stress.SetComponentName(2, "xy");
}

template <class Array>
void add_principal(Array& principal, double xx, double yy, double xy) {
  const double mean = (xx + yy) / 2;
  const double radius = std::hypot((xx - yy) / 2, xy);
  principal.InsertNextTuple2(mean + radius, mean - radius);
}

/// Polygons go as VTK_POLYGON cells: ParaView cuts those into triangles by their ears, so that concave blocks look
/// right, which the fans of plain poly data do not promise.
void fill_blocks(const Frame& frame, Grid& grid) {
  auto* displacement = grid.point_data("displacement_m", 3);
  auto* velocity = grid.point_data("velocity_m_per_s", 3);
  auto* id = grid.cell_data("block", 1);
  auto* stress = grid.cell_data("stress_pa", 3);
  auto* principal = grid.cell_data("principal_stress_pa", 2);
  auto* rotation = grid.cell_data("rotation_rad", 1);
  name_components(*stress);
  for (std::size_t b = 0; b < frame.blocks.size(); ++b) {
    const BlockRow& block = frame.blocks[b];
    std::vector<vtkIdType> ids;
    for (std::size_t v = 0; v < block.vertices_m.size(); ++v) {
      ids.push_back(grid.point(block.vertices_m[v]));
      add_vector(displacement, block.displacement_m[v]);
      add_vector(velocity, block.velocity_m_per_s[v]);
    }
    grid.cell(VTK_POLYGON, ids);
    id->InsertNextValue(static_cast<double>(b));
    stress->InsertNextTuple3(block.stress_xx_pa, block.stress_yy_pa, block.stress_xy_pa);
    add_principal(*principal, block.stress_xx_pa, block.stress_yy_pa, block.stress_xy_pa);
    rotation->InsertNextValue(block.rotation_rad);
  }
}

/// Triangles of meshed blocks, with stresses at their nodes.
void fill_mesh(const Frame& frame, Grid& grid) {
  auto* displacement = grid.point_data("displacement_m", 3);
  auto* stress = grid.point_data("stress_pa", 3);
  auto* principal = grid.point_data("principal_stress_pa", 2);
  auto* block = grid.cell_data("block", 1);
  name_components(*stress);
  for (const MeshRow& mesh : frame.meshes) {
    std::vector<vtkIdType> ids;
    for (std::size_t n = 0; n < mesh.nodes_m.size(); ++n) {
      const Eigen::Vector3d& s = mesh.stress_pa[n];
      ids.push_back(grid.point(mesh.nodes_m[n]));
      add_vector(displacement, mesh.displacement_m[n]);
      stress->InsertNextTuple3(s[0], s[1], s[2]);
      add_principal(*principal, s[0], s[1], s[2]);
    }
    for (const auto& t : mesh.triangles) {
      const auto id = [&](int corner) { return ids[static_cast<std::size_t>(corner)]; };
      grid.cell(VTK_TRIANGLE, {id(t[0]), id(t[1]), id(t[2])});
      block->InsertNextValue(mesh.block);
    }
  }
}

void fill_joints(const Frame& frame, Grid& grid) {
  auto* joint = grid.cell_data("joint", 1);
  auto* state = grid.cell_data("state", 1);  // 0 open, 1 stick, 2 slip
  auto* bonded = grid.cell_data("bonded_length_m", 1);
  auto* gap = grid.cell_data("gap_m", 1);
  auto* slip = grid.cell_data("slip_m", 1);
  auto* length = grid.cell_data("length_m", 1);
  auto* normal = grid.cell_data("normal_force_n_per_m", 1);
  auto* shear = grid.cell_data("shear_force_n_per_m", 1);
  auto* force = grid.cell_data("force_n_per_m", 3);
  for (const ContactRow& c : frame.contacts) {
    grid.cell(VTK_VERTEX, {grid.point(c.point_m)});
    joint->InsertNextValue(c.joint);
    state->InsertNextValue(c.state);
    bonded->InsertNextValue(c.bonded_length_m);
    gap->InsertNextValue(c.gap_m);
    slip->InsertNextValue(c.slip_m);
    length->InsertNextValue(c.length_m);
    normal->InsertNextValue(c.normal_force_n_per_m);
    shear->InsertNextValue(c.shear_force_n_per_m);
    const Point tangent(-c.normal.y(), c.normal.x());
    add_vector(force, c.normal_force_n_per_m * c.normal + c.shear_force_n_per_m * tangent);
  }
}

/// Pressures on wet panels, and the surface of each pool from the model's end to the structure.
void fill_water(const Frame& frame, Grid& grid) {
  auto* pressure = grid.point_data("pressure_pa", 1);
  auto* block = grid.cell_data("block", 1);
  auto* in_crack = grid.cell_data("in_crack", 1);
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  Point crest(0, -1e300);
  for (const BlockRow& b : frame.blocks) {
    for (const Point& p : b.vertices_m) {
      left = std::min(left, p.x());
      right = std::max(right, p.x());
      if (!b.fixed && p.y() > crest.y()) crest = p;
    }
  }
  const auto surface = [&](double level, double from, double to) {
    if (std::isnan(level)) return;
    grid.cell(VTK_LINE, {grid.point({from, level}), grid.point({to, level})});
    pressure->InsertNextValue(0);
    pressure->InsertNextValue(0);
    block->InsertNextValue(-1);
    in_crack->InsertNextValue(0);
  };
  for (const PanelRow& p : frame.panels) {
    grid.cell(VTK_LINE, {grid.point(p.from_m), grid.point(p.to_m)});
    pressure->InsertNextValue(p.pressure_from_pa);
    pressure->InsertNextValue(p.pressure_to_pa);
    block->InsertNextValue(p.block);
    in_crack->InsertNextValue(p.in_crack ? 1 : 0);
  }
  surface(frame.upstream_level_m, left, crest.x());
  surface(frame.downstream_level_m, crest.x(), right);
}

void fill_bolts(const Frame& frame, Grid& grid) {
  auto* force = grid.cell_data("force_n_per_m", 1);
  auto* elongation = grid.cell_data("elongation_m", 1);
  auto* state = grid.cell_data("state", 1);  // 0 elastic, 1 yielding, 2 slack
  for (const BoltRow& b : frame.bolts) {
    grid.cell(VTK_LINE, {grid.point(b.from_m), grid.point(b.to_m)});
    force->InsertNextValue(b.force_n_per_m);
    elongation->InsertNextValue(b.elongation_m);
    state->InsertNextValue(b.state);
  }
}

}  // namespace

VtkWriter::VtkWriter(const std::filesystem::path& folder) : files_(folder, "blocks.pvd") {}

void VtkWriter::write(const Frame& frame) {
  int part = 0;
  const auto save = [&](const char* name, void (*fill)(const Frame&, Grid&)) {
    Grid grid;
    fill(frame, grid);
    const std::string file = fmt::format("{}_{:06d}.vtu", name, count_);
    files_.add(grid, file, frame.time_s, name, part++);
    return file;
  };
  save("blocks", fill_blocks);
  if (frame.contacts.empty() && !without_contacts_.empty()) {
    files_.repeat(without_contacts_, frame.time_s, "joints", part++);
  } else {
    const std::string file = save("joints", fill_joints);
    if (frame.contacts.empty()) without_contacts_ = file;
  }
  save("water", fill_water);
  if (!frame.bolts.empty()) save("bolts", fill_bolts);
  if (!frame.meshes.empty()) save("mesh", fill_mesh);
  ++count_;
  files_.save();
}

}  // namespace blockweir::solid::output
