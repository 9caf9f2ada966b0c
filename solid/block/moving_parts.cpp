// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/block/moving_parts.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "bridge/geometry/mesh.hpp"
#include "bridge/geometry/outline.hpp"
#include "bridge/scene/at.hpp"

namespace blockweir::solid {
namespace {

/// A block of its own: it is its one part.
std::vector<OutlineSide> whole(int block, std::size_t edges) {
  std::vector<OutlineSide> outline;
  for (int e = 0; e < static_cast<int>(edges); ++e) outline.push_back({.part = block, .edge = e, .described_edge = e});
  return outline;
}

/// Energy of the domain of a side: 1/2 (A1 + A2)/3 e . D e with e = (A1 e1 + A2 e2)/(A1 + A2). Terms in one triangle's
/// strain alone go to its own stiffness.
void couple(MovingParts& parts, int i, int j) {
  Block& a = parts.blocks[at(i)];
  Block& b = parts.blocks[at(j)];
  const double share = 1 / (3 * (a.area + b.area));
  a.stiffness += share * a.area * a.area * a.elasticity;
  b.stiffness += share * b.area * b.area * b.elasticity;
  parts.couplings.push_back({i, j, share * a.area * b.area * a.elasticity});
}

void smooth(MovingParts& parts, const geometry::Mesh& mesh, int first, const Retardation& retardation) {
  std::map<std::pair<int, int>, int> side_of;  // (low node, high node): the triangle that was met first
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    parts.blocks[at(first + t)].stiffness.setZero();
    for (std::size_t s = 0; s < 3; ++s) {
      const std::pair<int, int> nodes = std::minmax(mesh.triangles[at(t)][s], mesh.triangles[at(t)][(s + 1) % 3]);
      const auto [other, is_first] = side_of.emplace(nodes, t);
      if (!is_first) couple(parts, first + other->second, first + t);
    }
  }
  for (const geometry::BoundarySide& side : mesh.boundary) {
    Block& triangle = parts.blocks[at(first + side.triangle)];
    triangle.stiffness += triangle.area / 3 * triangle.elasticity;
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) parts.blocks[at(first) + t].retardation = retardation;
}

void add_mesh(MovingParts& parts, const scene::Block& described, const scene::Material& material, scene::Plane plane,
              int block) {
  const geometry::Mesh mesh = geometry::triangulate(described.vertices, described.mesh_size_m);
  const int first = static_cast<int>(parts.blocks.size());
  for (const auto& corners : mesh.triangles) {
    scene::Block triangle = described;
    triangle.vertices.clear();
    for (const int node : corners) triangle.vertices.push_back(mesh.nodes[at(node)]);
    Block& part = parts.blocks.emplace_back(make_block(triangle, material, plane));
    for (std::size_t i = 0; i < 3; ++i) part.nodes[i] = parts.nodes + corners[i];
    parts.triangles[at(block)].push_back(static_cast<int>(parts.blocks.size()) - 1);
  }
  smooth(parts, mesh, first, parts.blocks[at(block)].retardation);
  for (const geometry::BoundarySide& side : mesh.boundary) {
    parts.outlines[at(block)].push_back({first + side.triangle, side.side, side.edge, side.s_from, side.s_to});
  }
  parts.nodes += static_cast<int>(mesh.nodes.size());
  parts.blocks[at(block)].meshed = true;
}

}  // namespace

MovingParts make_moving_parts(const scene::Scene& scene) {
  const auto material = [&](const scene::Block& block) { return scene.materials[at(block.material)]; };
  MovingParts parts;
  for (const scene::Block& block : scene.blocks) {
    parts.blocks.push_back(make_block(block, material(block), scene.analysis.plane));
  }
  parts.outlines.resize(scene.blocks.size());
  parts.triangles.resize(scene.blocks.size());
  for (int b = 0; b < static_cast<int>(scene.blocks.size()); ++b) {
    const scene::Block& block = scene.blocks[at(b)];
    if (block.mesh_size_m > 0) {
      add_mesh(parts, block, material(block), scene.analysis.plane, b);
    } else {
      parts.outlines[at(b)] = whole(b, block.vertices.size());
    }
  }
  parts.contact_outlines = contact_outlines(scene, parts.blocks);
  for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
    if (parts.triangles[b].empty()) continue;
    for (const OutlineSide& side : parts.outlines[b]) {
      parts.contact_outlines[b].push_back(
          {side.part, side.described_edge, side.s_from, side.s_to, parts.vertex(side), parts.end(side)});
    }
  }
  return parts;
}

Anchor MovingParts::anchor(int block, const Point& point) const {
  if (triangles[at(block)].empty()) return {block, point - blocks[at(block)].centroid};
  Anchor nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const int t : triangles[at(block)]) {
    const Point material = point - blocks[at(t)].centroid;
    const auto& X = blocks[at(t)].vertices;
    double outside = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const Point side = X[(i + 1) % 3] - X[i];
      outside = std::max(outside, -perpendicular(side).dot(material - X[i]) / side.norm());
    }
    if (outside >= least) continue;
    least = outside;
    nearest = {t, material};
  }
  return nearest;
}

void MovingParts::split(const Panel& panel, std::vector<Panel>& panels) const {
  if (triangles[at(panel.block)].empty()) {
    panels.push_back(panel);
    return;
  }
  const double span = panel.s_to - panel.s_from;
  for (const OutlineSide& side : outlines[at(panel.block)]) {
    if (side.described_edge != panel.edge) continue;
    const double from = std::max(panel.s_from, side.s_from);
    const double to = std::min(panel.s_to, side.s_to);
    if (to <= from) continue;
    const auto along = [&](double s) { return (s - side.s_from) / (side.s_to - side.s_from); };
    const auto pressure = [&](double s) {
      return panel.pressure_from_pa + (panel.pressure_to_pa - panel.pressure_from_pa) * (s - panel.s_from) / span;
    };
    panels.push_back({side.part, side.edge, along(from), along(to), pressure(from), pressure(to)});
  }
}

}  // namespace blockweir::solid
