// SPDX-License-Identifier: GPL-3.0-or-later
// links: fluid_hydrostatic
// The reservoir's triangles fill the pool, carry a linear pressure exactly and meet the blocks in the load's nodes.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <map>
#include <set>

#include "bridge/geometry/polygon.hpp"
#include "fluid/hydrostatic/hydrostatic_model.hpp"

namespace blockweir::hydrostatic::reservoir_mesh_test {
namespace {

using geometry::signed_area;

/// A dam on a ground with a block that lies under water before it; 20 elements to a face.
std::vector<std::vector<Point>> dam_and_sunken_block() {
  return {{{-30, -2}, {20, -2}, {20, 0}, {-30, 0}},
          {{0, 0}, {9, 0}, {3, 13}, {1, 13}},
          {{-9, 2}, {-6, 1.5}, {-5, 4}, {-8, 5}}};
}

PoolSection pool_at(double level_m, const std::vector<std::vector<Point>>& outlines, wire::Load& load) {
  scene::Scene scene;
  scene.materials.push_back({"concrete", 50e9, 0.2, 2500});
  for (const auto& outline : outlines) {
    scene.blocks.emplace_back();
    scene.blocks.back().name = std::to_string(scene.blocks.size());
    scene.blocks.back().vertices = outline;
  }
  scene.water.upstream_level_m = scene::TimeTable::constant(level_m);
  scene.output.reservoir = true;
  HydrostaticModel model(scene);
  wire::Motion motion;
  motion.displacement.own().resize(outlines.size());
  model.advance(motion, 0, load);
  return model.sections().at(0);
}

double area_of(const ReservoirMesh& mesh, const std::array<std::size_t, 3>& t) {
  return geometry::signed_area(std::vector<Point>{mesh.node[t[0]], mesh.node[t[1]], mesh.node[t[2]]});
}

TEST(ReservoirMesh, TrianglesFillThePool) {
  wire::Load load;
  const PoolSection pool = pool_at(11.3, dam_and_sunken_block(), load);
  const ReservoirMesh mesh = mesh_reservoir(pool.region, pool.interface, 0.6, 0.01);
  double area = 0;
  for (const auto& t : mesh.triangle) {
    EXPECT_GT(area_of(mesh, t), 0);
    area += area_of(mesh, t);
  }
  double region = 0;
  for (const Ring& ring : pool.region) region += geometry::signed_area(ring);
  EXPECT_NEAR(area / region, 1, 1e-12);
  EXPECT_GT(mesh.triangle.size(), 1500U);
}

TEST(ReservoirMesh, LinearPressureHasItsGradientInEveryTriangle) {
  wire::Load load;
  const PoolSection pool = pool_at(11.3, dam_and_sunken_block(), load);
  const ReservoirMesh mesh = mesh_reservoir(pool.region, pool.interface, 0.6, 0.01);
  Point buoyancy(0, 0);  // integral of grad p over the section, which is the force on its boundary
  for (const auto& t : mesh.triangle) {
    Eigen::Matrix2d sides;
    Point rises;
    for (int k = 0; k < 2; ++k) {
      sides.row(k) = mesh.node[t[static_cast<std::size_t>(k) + 1]] - mesh.node[t[0]];
      rises[k] = pool.water.pressure(mesh.node[t[static_cast<std::size_t>(k) + 1]].y()) -
                 pool.water.pressure(mesh.node[t[0]].y());
    }
    const Point gradient = sides.inverse() * rises;
    EXPECT_NEAR(gradient.x() / 9810, 0, 1e-8);
    EXPECT_NEAR(gradient.y() / 9810, -1, 1e-8);
    buoyancy += area_of(mesh, t) * gradient;
  }
  double region = 0;
  for (const Ring& ring : pool.region) region += geometry::signed_area(ring);
  EXPECT_NEAR(buoyancy.y() / (-9810 * region), 1, 1e-12);
}

TEST(ReservoirMesh, ElementsOfTheLoadAreEdgesOfTheMesh) {
  wire::Load load;
  const PoolSection pool = pool_at(11.3, dam_and_sunken_block(), load);
  ASSERT_EQ(pool.interface.size(), load.block.size());
  const ReservoirMesh mesh = mesh_reservoir(pool.region, pool.interface, 0.6, 0.01);
  std::map<std::pair<double, double>, std::size_t> number;
  for (std::size_t i = 0; i < mesh.node.size(); ++i) number[{mesh.node[i].x(), mesh.node[i].y()}] = i;
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& t : mesh.triangle) {
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  for (std::size_t i = 0; i < pool.interface.size(); ++i) {
    const auto& [a, b] = pool.interface[i];
    ASSERT_EQ(number.count({a.x(), a.y()}) + number.count({b.x(), b.y()}), 2U) << "element " << i;
    const std::size_t from = number[{a.x(), a.y()}];
    const std::size_t to = number[{b.x(), b.y()}];
    EXPECT_EQ(edges.count(std::minmax(from, to)), 1U)
        << "element " << i << " from " << a.transpose() << " to " << b.transpose();
    EXPECT_DOUBLE_EQ(pool.water.pressure(mesh.node[from].y()), load.pressure_from_pa[i]);
  }
}

TEST(ReservoirMesh, AWidePoolIsNotMeshedFinerThanFiftyThousandNodes) {
  const std::vector<Ring> wide = {{{0, 0}, {1000, 0}, {1000, 100}, {0, 100}}};
  const ReservoirMesh mesh = mesh_reservoir(wide, {}, 0.01, 1e-3);
  EXPECT_GT(mesh.node.size(), 20000U);
  EXPECT_LT(mesh.node.size(), 80000U);
}

TEST(ReservoirMesh, AnEmptyPoolHasNone) {
  EXPECT_TRUE(mesh_reservoir({}, {}, 1, 1e-3).triangle.empty());
}

}  // namespace
}  // namespace blockweir::hydrostatic::reservoir_mesh_test
