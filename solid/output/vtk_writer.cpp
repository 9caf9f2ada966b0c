// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/output/vtk_writer.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockweir::solid::output {
namespace {

using vtk::Array;
using vtk::Cell;
using vtk::Grid;

void add_principal(Array& principal, double xx, double yy, double xy) {
  const double mean = (xx + yy) / 2;
  const double radius = std::hypot((xx - yy) / 2, xy);
  principal.add({mean + radius, mean - radius});
}

/// Polygons go as VTK_POLYGON cells: ParaView cuts those into triangles by their ears, so that concave blocks look
/// right, which the fans of plain poly data do not promise.
void fill_blocks(const Frame& frame, Grid& grid) {
  Array& displacement = grid.point_data("displacement_m", 3);
  Array& velocity = grid.point_data("velocity_m_per_s", 3);
  Array& id = grid.cell_data("block", 1);
  Array& stress = grid.cell_data("stress_pa", 3);
  Array& principal = grid.cell_data("principal_stress_pa", 2);
  Array& rotation = grid.cell_data("rotation_rad", 1);
  stress.component_names = {"xx", "yy", "xy"};
  for (std::size_t b = 0; b < frame.blocks.size(); ++b) {
    const BlockRow& block = frame.blocks[b];
    std::vector<vtk::Id> ids;
    for (std::size_t v = 0; v < block.vertices_m.size(); ++v) {
      ids.push_back(grid.point(block.vertices_m[v]));
      displacement.add(block.displacement_m[v]);
      velocity.add(block.velocity_m_per_s[v]);
    }
    grid.cell(Cell::polygon, ids);
    id.add(static_cast<double>(b));
    stress.add({block.stress_xx_pa, block.stress_yy_pa, block.stress_xy_pa});
    add_principal(principal, block.stress_xx_pa, block.stress_yy_pa, block.stress_xy_pa);
    rotation.add(block.rotation_rad);
  }
}

/// Triangles of meshed blocks, with stresses at their nodes.
void fill_mesh(const Frame& frame, Grid& grid) {
  Array& displacement = grid.point_data("displacement_m", 3);
  Array& stress = grid.point_data("stress_pa", 3);
  Array& principal = grid.point_data("principal_stress_pa", 2);
  Array& block = grid.cell_data("block", 1);
  stress.component_names = {"xx", "yy", "xy"};
  for (const MeshRow& mesh : frame.meshes) {
    std::vector<vtk::Id> ids;
    for (std::size_t n = 0; n < mesh.nodes_m.size(); ++n) {
      const Eigen::Vector3d& s = mesh.stress_pa[n];
      ids.push_back(grid.point(mesh.nodes_m[n]));
      displacement.add(mesh.displacement_m[n]);
      stress.add({s[0], s[1], s[2]});
      add_principal(principal, s[0], s[1], s[2]);
    }
    for (const auto& t : mesh.triangles) {
      const auto id = [&](int corner) { return ids[static_cast<std::size_t>(corner)]; };
      grid.cell(Cell::triangle, {id(t[0]), id(t[1]), id(t[2])});
      block.add(mesh.block);
    }
  }
}

void fill_joints(const Frame& frame, Grid& grid) {
  Array& joint = grid.cell_data("joint", 1);
  Array& state = grid.cell_data("state", 1);  // 0 open, 1 stick, 2 slip
  Array& bonded = grid.cell_data("bonded_length_m", 1);
  Array& gap = grid.cell_data("gap_m", 1);
  Array& slip = grid.cell_data("slip_m", 1);
  Array& length = grid.cell_data("length_m", 1);
  Array& normal = grid.cell_data("normal_force_n_per_m", 1);
  Array& shear = grid.cell_data("shear_force_n_per_m", 1);
  Array& force = grid.cell_data("force_n_per_m", 3);
  for (const ContactRow& c : frame.contacts) {
    grid.cell(Cell::vertex, {grid.point(c.point_m)});
    joint.add(c.joint);
    state.add(c.state);
    bonded.add(c.bonded_length_m);
    gap.add(c.gap_m);
    slip.add(c.slip_m);
    length.add(c.length_m);
    normal.add(c.normal_force_n_per_m);
    shear.add(c.shear_force_n_per_m);
    const Point tangent(-c.normal.y(), c.normal.x());
    force.add(c.normal_force_n_per_m * c.normal + c.shear_force_n_per_m * tangent);
  }
}

/// Pressures on wet panels, and the surface of each pool from the model's end to the structure.
void fill_water(const Frame& frame, Grid& grid) {
  Array& pressure = grid.point_data("pressure_pa", 1);
  Array& block = grid.cell_data("block", 1);
  Array& in_crack = grid.cell_data("in_crack", 1);
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
    grid.cell(Cell::line, {grid.point({from, level}), grid.point({to, level})});
    pressure.add(0);
    pressure.add(0);
    block.add(-1);
    in_crack.add(0);
  };
  for (const PanelRow& p : frame.panels) {
    grid.cell(Cell::line, {grid.point(p.from_m), grid.point(p.to_m)});
    pressure.add(p.pressure_from_pa);
    pressure.add(p.pressure_to_pa);
    block.add(p.block);
    in_crack.add(p.in_crack ? 1 : 0);
  }
  surface(frame.upstream_level_m, left, crest.x());
  surface(frame.downstream_level_m, crest.x(), right);
}

void fill_bolts(const Frame& frame, Grid& grid) {
  Array& force = grid.cell_data("force_n_per_m", 1);
  Array& elongation = grid.cell_data("elongation_m", 1);
  Array& state = grid.cell_data("state", 1);  // 0 elastic, 1 yielding, 2 slack
  for (const BoltRow& b : frame.bolts) {
    grid.cell(Cell::line, {grid.point(b.from_m), grid.point(b.to_m)});
    force.add(b.force_n_per_m);
    elongation.add(b.elongation_m);
    state.add(b.state);
  }
}

}  // namespace

VtkWriter::VtkWriter(const std::filesystem::path& folder) : files_(folder, "blocks.pvd") {}

void VtkWriter::write(const Frame& frame) {
  constexpr std::size_t few_blocks = 20;  // two processes keep two cores busy in such short windows
  finish();
  if (frame.blocks.size() < few_blocks) return write_files(frame);
  writing_ = std::async(std::launch::async, [this, frame] {
    (void)!::nice(10);  // on Linux, of this thread: the exchange has the processors first
    write_files(frame);
  });
}

void VtkWriter::finish() {
  if (writing_.valid()) writing_.get();
}

void VtkWriter::write_files(const Frame& frame) {
  int part = 0;
  const auto save = [&](const char* name, void (*fill)(const Frame&, Grid&)) {
    Grid grid;
    fill(frame, grid);
    const std::string file = fmt::format("{}_{:06d}.vtu", name, count_);
    files_.add(grid, file, frame.time_s, name, part++);
    return file;
  };
  save("blocks", fill_blocks);
  if (frame.contacts.empty() && !without_contacts_.empty() && files_.has(without_contacts_)) {
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
