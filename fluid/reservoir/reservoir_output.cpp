// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/reservoir/reservoir_output.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bridge/results/is_due.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::reservoir {
namespace {

bool absorbs(const FarEnd& end, double x, int side) {
  return end.absorbs_from_m && side * (x - *end.absorbs_from_m) > 0;
}

}  // namespace

ReservoirOutput::ReservoirOutput(const scene::Scene& scene, const std::filesystem::path& folder)
    : scene_(scene), files_(folder, "reservoir.pvd") {}

void ReservoirOutput::record(double time_s, const std::vector<AnsweringWater>& waters) {
  if (!results::is_due(time_s, scene_.output.frame_every_s, next_s_)) return;
  Picture picture;
  for (const AnsweringWater& water : waters) add(water, picture);
  files_.add(picture.grid, fmt::format("reservoir_{:06d}.vtu", frame_++), time_s, "reservoir");
  files_.save();
}

void ReservoirOutput::add(const AnsweringWater& water, Picture& picture) const {
  const WaterMesh& mesh = water.mesh();
  const Eigen::VectorXd added = water.pressure_at_nodes();
  const auto higher = [](const Point& a, const Point& b) { return a.y() < b.y(); };
  const double level_m = std::max_element(mesh.node.begin(), mesh.node.end(), higher)->y();
  const scene::Hydrostatics still = scene::on_wet_faces(scene_, level_m);
  std::vector<vtk::Id> ids(mesh.node.size(), -1);
  const auto point = [&](int node) {
    vtk::Id& id = ids[at(node)];
    if (id >= 0) return id;
    id = picture.grid.point(mesh.node[at(node)]);
    picture.pressure.add(still.pressure(mesh.node[at(node)].y()) + added[node]);
    picture.added.add(added[node]);
    return id;
  };
  for (const QuadraticTriangle& t : mesh.triangle) {
    const double x = (mesh.node[at(t[0])] + mesh.node[at(t[1])] + mesh.node[at(t[2])]).x() / 3;
    if (absorbs(mesh.ends.left, x, -1) || absorbs(mesh.ends.right, x, 1)) continue;
    std::vector<vtk::Id> corners;
    for (const int node : t) corners.push_back(point(node));
    picture.grid.cell(vtk::Cell::quadratic_triangle, corners);
  }
}

}  // namespace blockweir::reservoir
