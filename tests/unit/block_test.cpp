// SPDX-License-Identifier: GPL-3.0-or-later
// links: solid_block
// Exact moments, the mass matrix and the shape matrix of a block.
#include <gtest/gtest.h>

#include "bridge/geometry/polygon_moments.hpp"
#include "solid/block/panel.hpp"

namespace blockweir::solid::block_test {
namespace {

scene::Block outline(std::vector<Point> vertices) {
  scene::Block block;
  block.name = "b";
  block.vertices = std::move(vertices);
  return block;
}

const scene::Material concrete{"concrete", 50e9, 0.2, 2500};

TEST(Block, MomentsOfARectangleFarFromTheOriginAreExact) {
  const std::vector<Point> r = {{1000, 500}, {1006, 500}, {1006, 508}, {1000, 508}};
  const geometry::PolygonMoments m = geometry::polygon_moments(r);
  EXPECT_DOUBLE_EQ(m.area, 48);
  EXPECT_DOUBLE_EQ(m.centroid.x(), 1003);
  EXPECT_DOUBLE_EQ(m.xx, 8 * 6.0 * 6 * 6 / 12);
  EXPECT_DOUBLE_EQ(m.yy, 6 * 8.0 * 8 * 8 / 12);
  EXPECT_NEAR(m.xy, 0, 1e-12);
}

TEST(Block, MassMatrixIsTheIntegralOfTheShapeMatrix) {
  // Gauss points that are exact for quadratics on each triangle of a fan, against the moments in closed form.
  const std::vector<Point> vertices = {{0, 0}, {3, 0.5}, {2, 2}, {0.5, 1.5}};
  const Block block = make_block(outline(vertices), concrete, scene::Plane::strain);
  Matrix6 sum = Matrix6::Zero();
  const Placement rest(Point::Zero(), Vector6::Zero());
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = block.vertices[i];
    const Point b = block.vertices[(i + 1) % 4];
    const double area = (a.x() * b.y() - a.y() * b.x()) / 2;
    for (const Point& p : {Point(a / 2), Point(b / 2), Point((a + b) / 2)}) {
      const Matrix26 T = rest.shape(p);
      sum += 2500 * area / 3 * T.transpose() * T;
    }
  }
  EXPECT_LT((sum - block.inertia.matrix()).cwiseAbs().maxCoeff(), 1e-9 * block.inertia.matrix().maxCoeff());
}

TEST(Block, ShapeMatrixIsTheDerivativeOfThePosition) {
  Vector6 d;
  d << 0.3, -0.2, 1.1, 0.01, -0.02, 0.03;
  const Point X(1.5, -0.7);
  const Matrix26 T = Placement(Point(2, 3), d).shape(X);
  for (int k = 0; k < 6; ++k) {
    Vector6 step = Vector6::Zero();
    step[k] = 1e-6;
    const Point slope =
        (Placement(Point(2, 3), d + step).position(X) - Placement(Point(2, 3), d - step).position(X)) / 2e-6;
    EXPECT_LT((slope - T.col(k)).norm(), 1e-8) << "column " << k;
  }
}

TEST(Block, IncrementIsTheDifferenceOfPositions) {
  Vector6 d;
  d << 0.3, -0.2, 0.4, 0.01, -0.02, 0.03;
  Vector6 step;
  step << 1e-3, 2e-3, 0.2, 1e-4, -2e-4, 3e-4;
  const Point X(1.5, -0.7);
  const Placement start(Point(2, 3), d);
  const Point moved = Placement(Point(2, 3), d + step).position(X) - start.position(X);
  EXPECT_LT((start.increment(step, X) - moved).norm(), 1e-14);
}

/// What lies on its head has turned by half, and a stone that rolls by more: figures of points ask for all of it.
TEST(Block, AnIncrementMayBeAnyTurn) {
  const Point X(1.5, -0.7);
  const Placement start(Point(2, 3), Vector6::Zero());
  for (const double turn : {-9.0, -3.5, 3.1, 4.0, 7.0}) {
    Vector6 d = Vector6::Zero();
    d[2] = turn;
    const Point moved = Placement(Point(2, 3), d).position(X) - start.position(X);
    EXPECT_LT((start.increment(d, X) - moved).norm(), 1e-14) << turn;
  }
}

TEST(Block, ASmallIncrementLosesNoDigits) {
  Vector6 step = Vector6::Zero();
  step[2] = 1e-13;
  const Point moved = Placement(Point(2e3, 3e3), Vector6::Zero()).increment(step, Point(10, 0));
  EXPECT_DOUBLE_EQ(moved.y(), 1e-12);
}

/// As an edge's wet part may have, going on in time beyond the last exchange.
TEST(Block, APanelWithoutLengthHasNoForce) {
  const Block block = make_block(outline({{0, 0}, {3, 0.5}, {2, 2}, {0.5, 1.5}}), concrete, scene::Plane::strain);
  const Placement placement(block.centroid, Vector6::Zero());
  const Panel panel{.block = 0, .edge = 1, .s_from = 0.4, .s_to = 0.4, .pressure_from_pa = 3e4, .pressure_to_pa = 1e4};
  EXPECT_EQ(generalized_force(placement, panel_force(block, placement, panel, scene::NodalRule::consistent)),
            Vector6(Vector6::Zero()));
}

TEST(Block, LeverRuleOnAnEdgeEqualsVirtualWork) {
  const Block block = make_block(outline({{0, 0}, {3, 0.5}, {2, 2}, {0.5, 1.5}}), concrete, scene::Plane::strain);
  Vector6 d;
  d << 0.3, -0.2, 1.1, 0.01, -0.02, 0.03;
  const Placement placement(block.centroid, d);
  const Panel panel{.block = 0, .edge = 1, .s_from = 0.2, .s_to = 0.9, .pressure_from_pa = 3e4, .pressure_to_pa = 1e4};
  const PanelForce acting = panel_force(block, placement, panel, scene::NodalRule::consistent);
  // (11): each nodal force shared between the edge's vertices in proportion to the distances.
  Vector6 by_levers = Vector6::Zero();
  for (int i = 0; i < 2; ++i) {
    const double s = i == 0 ? 0.2 : 0.9;
    by_levers += placement.shape(block.vertices[1]).transpose() * ((1 - s) * acting.force[static_cast<std::size_t>(i)]);
    by_levers += placement.shape(block.vertices[2]).transpose() * (s * acting.force[static_cast<std::size_t>(i)]);
  }
  const Vector6 by_work = generalized_force(placement, acting);
  EXPECT_LT((by_levers - by_work).norm(), 1e-12 * by_work.norm());
}

}  // namespace
}  // namespace blockweir::solid::block_test
